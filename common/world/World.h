#pragma once

#include <cstdint>
#include <optional>

#include "common/world/Hands.h"
#include "common/world/WorldModel.h"
#include "common/world/WorldState.h"

namespace coherency {

/// The rules of one world: how a state follows from the one before and a sample. Const: what changes is the
/// state alone. Every number it takes into a state is made of additions, multiplications, divisions, square
/// roots and rounding, so that the same samples give the same bits with every compiler, flag and library.
class World {
 public:
  /// Throws std::invalid_argument where the model has more doors or movables than a state holds.
  explicit World(WorldModel model);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const WorldModel& model() const { return model_; }

  /// Everything where the model has it.
  WorldState initialState() const;
  /// Whether a state is one of this world's: one that can be (isValid()), with as many movables and doors, in
  /// a mode and in hands there are, and no faster than anything here drives.
  bool fits(const WorldState& state) const;
  /// One period. Order: vehicles, doors, hands, movables, the task's clock. Throws std::invalid_argument
  /// where the state is another world's.
  void step(WorldState& state, const MotionSample& sample, std::int64_t period_ns) const;

  /// Whether there is such a mode here: a robot to be, or not.
  bool has(Mode mode) const { return mode == Mode::Operator || model_.robot.has_value(); }

  /// The hand that holds: T_base_hand, for placing what it carries. Precondition: which is a hand there is.
  const GraspingHand& hand(Holder which) const { return which == Holder::RobotHand ? *robot_hand_ : hand_; }

 private:
  bool hasPartsOf(const WorldState& state) const;
  void stepVehicles(WorldState& state, const MotionSample& sample, std::int64_t period_ns) const;
  void stepDoors(WorldState& state, std::int64_t period_ns) const;

  WorldModel model_;
  GraspingHand hand_;
  std::optional<GraspingHand> robot_hand_;
};

}  // namespace coherency
