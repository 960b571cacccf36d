#pragma once

#include <cstdint>
#include <memory>

#include "common/body/Rig.h"
#include "motion_server/device/Master.h"
#include "motion_server/device/simulated/Operator.h"

namespace coherency {

/// An operator made of nothing but a seed, who works as people do: drives to the workplace, looks at a block
/// before reaching for it, leans when it is far, grips it, carries it onto another, builds a tower and takes
/// it down again, rests, looks about. Reaches and gaze shifts are minimum-jerk with durations by Fitts' law
/// and the main sequence, and small sway is band-limited noise. Closed loop: it sees where the base, the
/// blocks and its hand are. Position and velocity of every DOF are continuous; the same seed and the same
/// world give the same motion.
class SimulatedMaster final : public Master {
 public:
  using Task = OperatorTask;

  SimulatedMaster(const Task& task, const Rig& rig, std::uint64_t seed);

  std::string name() const override { return "simulated operator"; }
  /// Never ends. Times must not go back.
  std::optional<MasterReading> read(std::int64_t elapsed_ns, const WorldState& world) override;

 private:
  /// The small unrest of somebody who sits still.
  struct Sway {
    explicit Sway(std::uint64_t seed);
    SmoothNoise lean_forward, lean_right, yaw, pitch, roll;
    std::vector<SmoothNoise> joints;
  };

  void feel(const MasterReading& reading);

  SeatedBody body_;
  ArmKinematics kinematics_;
  TransformMatrix felt_;  ///< T_body_hand of the last reading
  Operator operator_;
  Sway sway_;
};

}  // namespace coherency
