#pragma once

#include <optional>

#include "common/world/WorldState.h"
#include "motion_server/device/simulated/MinimumJerk.h"

namespace coherency {

/// A place on the floor to drive to, metres and radians as BasePose means them.
struct DriveGoal {
  double x = 0.0;
  double z = 0.0;
  double heading = 0.0;
};
DriveGoal driveGoal(const BasePose& base);

/// Left hand on the stick and feet on the pedals: steers by what is seen of the base's place, as a person
/// does, with a hand's bandwidth. Turns towards a far goal, drives ahead, slows down, and takes up the final
/// heading near it.
class Driver {
 public:
  void driveTo(const DriveGoal& goal) { goal_ = goal; }
  void letGo() { goal_.reset(); }

  /// Advances hands and feet by `dt_s`.
  void update(const WorldState& world, double dt_s);
  /// At the goal and at rest; also true without one.
  bool arrived(const WorldState& world) const;

  double stickX() const { return stick_x_.value(); }
  double stickY() const { return stick_y_.value(); }
  double stickTwist() const { return twist_.value(); }
  double pedalLeft() const { return brake_.value(); }
  double pedalRight() const { return boost_.value(); }
  /// How the trunk answers to the seat's acceleration.
  double leanForward() const { return lean_forward_.value(); }
  double leanRight() const { return lean_right_.value(); }

 private:
  struct Command;
  Command command(const WorldState& world) const;
  void answerAcceleration(const WorldState& world, double dt_s);

  std::optional<DriveGoal> goal_;
  Follower stick_x_{9.0}, stick_y_{9.0}, twist_{9.0}, brake_{9.0}, boost_{5.0};
  Follower speed_ahead_{8.0}, speed_right_{8.0};  // their rates are the accelerations felt
  Follower lean_forward_{6.0}, lean_right_{6.0};
};

}  // namespace coherency
