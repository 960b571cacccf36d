#include "tests/render/Seated.h"

#include "common/motion/SampleGate.h"

namespace coherency {

void sit(Scene& scene, const Seat& seat) {
  const Rig& rig = scene.human().rig();
  MasterReading reading;
  reading.si = neutralPosture(rig);
  for (const auto& [dof, by] : {std::pair{Dof::HeadX, seat.lean.x},
                                {Dof::HeadY, seat.lean.y},
                                {Dof::HeadZ, seat.lean.z},
                                {Dof::HeadYaw, seat.turn.yaw},
                                {Dof::HeadPitch, seat.turn.pitch},
                                {Dof::HeadRoll, seat.turn.roll}})
    reading.si[index(dof)] += by;
  const MotionSample sample = SampleGate(neutralPosture(rig)).admit(reading, 1, 0);
  for (std::size_t i = 0; i < kDofCount; ++i) ASSERT_TRUE(sample.isValid(dofAt(i))) << info(dofAt(i)).name;
  WorldState state = scene.initialState();
  state.master.base = seat.base;
  scene.apply(state, sample);
}

}  // namespace coherency
