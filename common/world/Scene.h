#pragma once

#include <memory>
#include <vector>

#include "common/body/SlaveRobot.h"
#include "common/body/VirtualHuman.h"
#include "common/scene/Light.h"
#include "common/world/Gather.h"
#include "common/world/Places.h"
#include "common/world/SceneDescription.h"
#include "common/world/World.h"

namespace coherency {

struct Stage;

/// A world to be in, as a tree: the virtual human, the slave robot where there is one, and the objects that
/// its description names. What the objects are to the world (in the way, to be grasped, a door, a lamp)
/// stands in their attributes (common/scene/Physical.h, Light.h) and is gathered here once.
class Scene : public VRObject {
 public:
  /// Throws std::domain_error where the rig is not valid, and std::invalid_argument naming the objects where
  /// one is of no known kind, two have one name, a name cannot be one, one stands in another or in what
  /// drives, something that stands in the way is tilted or scaled, or there is no room to scatter.
  Scene(const SceneDescription& description, const Rig& rig);
  ~Scene() override;

  const SceneDescription& description() const { return description_; }
  VirtualHuman& human() { return human_; }
  const VirtualHuman& human() const { return human_; }
  /// Null where the scene has none.
  const SlaveRobot* robot() const { return robot_.get(); }
  /// Whose eyes they are depends on the mode.
  const ViewPoint& eye(Eye which, Mode mode) const;
  /// Likewise the right wrist's frame.
  const VRObject& hand(Mode mode) const;

  /// The rules by which its states go on.
  const World& world() const { return *world_; }
  /// Where a session begins. Seed 0: everything where the description has it; others: what can be grasped is
  /// scattered over the description's area. Throws std::invalid_argument where there are things to scatter
  /// and no area, or no room in it.
  WorldState initialState(std::uint64_t seed = 0) const;
  /// Where the base of whom the mode says should be to work: as the description has it for the default rig;
  /// somebody of another size keeps their front as far from what they work at. Precondition: the mode is
  /// there.
  BasePose workplace(Mode mode) const;
  /// DOFs that move anything here; a scene that only looks has six.
  DofMask dofs() const;

  const std::vector<Light>& lights() const { return lights_; }  ///< positions in the world
  const Ambient& ambient() const { return ambient_; }
  /// Places worth putting a hand to, in world coordinates (Reachable).
  const std::vector<Coord3>& targets() const { return targets_; }

  /// Brings the tree into the given state and posture. Precondition: the state has this world's movables and
  /// doors.
  void apply(const WorldState& state, const MotionSample& sample);
  /// World::fits().
  bool fits(const WorldState& state) const { return world_->fits(state); }

 private:
  void addObjects(Stage& stage);
  void gather(WorldModel& model);
  void placeWork(const WorldModel& model);
  VehiclePlaces places(Mode mode) const;
  void applyMovables(const WorldState& state);

  SceneDescription description_;
  BasePose workplace_;
  BasePose robot_workplace_;
  Rig rig_;
  VirtualHuman human_;
  std::unique_ptr<SlaveRobot> robot_;
  std::vector<std::unique_ptr<VRObject>> objects_;
  std::vector<VRObject*> movables_;
  std::vector<DoorLeaf> doors_;
  std::vector<Light> lights_;
  Ambient ambient_;
  std::vector<Coord3> targets_;
  std::unique_ptr<World> world_;
};

}  // namespace coherency
