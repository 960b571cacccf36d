#include "motion_server/device/simulated/Driver.h"

#include <algorithm>
#include <cmath>

#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr double kFullStick = 0.7;         // people do not push it to the stop
constexpr double kPerMetre = 1.6;          // stick for each metre still to go
constexpr double kPerRadian = 1.1;         // twist for each radian still to turn
constexpr double kNear = 0.5, kFar = 1.2;  // m; from near on the final heading is taken up
constexpr double kBrakeAbove = 1.3;        // m/s for each metre to go: faster needs the brake
constexpr double kBrakePerSpeed = 2.0;
constexpr double kBoostFrom = 2.0;             // m
constexpr double kPlaceReached = 0.02;         // m
constexpr double kHeadingReached = 0.03;       // rad
constexpr double kAtRest = 0.02;               // m/s and rad/s
constexpr double kLeanPerAcceleration = 0.03;  // rad for 1 m/s^2

double wrapped(double angle) {
  return std::remainder(angle, kTurn);
}

/// The goal as seen from the base.
struct Way {
  double right;
  double ahead;
  double distance;
  double turn;        ///< to the final heading, positive to the left
  double turn_there;  ///< to face the goal's place
};

Way wayTo(const DriveGoal& goal, const BasePose& base) {
  const DriveGoal now = driveGoal(base);
  const double dx = goal.x - now.x;
  const double dz = goal.z - now.z;
  const double c = std::cos(now.heading);
  const double s = std::sin(now.heading);
  return {c * dx - s * dz, -s * dx - c * dz, std::hypot(dx, dz), wrapped(goal.heading - now.heading),
          wrapped(std::atan2(-dx, -dz) - now.heading)};
}

double speed(const WorldState& world) {
  return std::hypot(world.driven().velocity_right_um, world.driven().velocity_ahead_um) * kMicrometre;
}

double saturated(double stick) {
  return kFullStick * std::tanh(stick / kFullStick);
}

}  // namespace

DriveGoal driveGoal(const BasePose& base) {
  return {metresFromNanometres(base.x_nm), metresFromNanometres(base.z_nm),
          radiansFromUnits(base.heading_units)};
}

struct Driver::Command {
  double x = 0.0, y = 0.0, twist = 0.0, brake = 0.0, boost = 0.0;
};

Driver::Command Driver::command(const WorldState& world) const {
  if (!goal_ || arrived(world)) return {};
  const Way way = wayTo(*goal_, world.driven().base);
  // Behind and near: one drives backwards; otherwise one first turns, then goes.
  const double far = minimumJerk((way.distance - kNear) / (kFar - kNear));
  const double turn = way.turn + far * wrapped(way.turn_there - way.turn);
  const double aligned = 1.0 - far * (1.0 - std::max(0.0, std::cos(turn)));
  const double pull = way.distance > 0.0 ? saturated(kPerMetre * way.distance) * aligned / way.distance : 0.0;
  Command c;
  c.x = way.right * pull;
  c.y = way.ahead * pull;
  c.twist = saturated(kPerRadian * turn);
  c.brake = std::clamp(kBrakePerSpeed * (speed(world) - kBrakeAbove * way.distance), 0.0, 0.5);
  c.boost = way.distance > kBoostFrom ? 0.4 * aligned : 0.0;
  return c;
}

bool Driver::arrived(const WorldState& world) const {
  if (!goal_) return true;
  const Way way = wayTo(*goal_, world.driven().base);
  return way.distance < kPlaceReached && std::abs(way.turn) < kHeadingReached && speed(world) < kAtRest &&
         std::abs(world.driven().turn_rate_units * kAngleUnit) < kAtRest;
}

void Driver::answerAcceleration(const WorldState& world, double dt_s) {
  speed_ahead_.follow(world.driven().velocity_ahead_um * kMicrometre, dt_s);
  speed_right_.follow(world.driven().velocity_right_um * kMicrometre, dt_s);
  lean_forward_.follow(-kLeanPerAcceleration * speed_ahead_.rate(), dt_s);
  lean_right_.follow(-kLeanPerAcceleration * speed_right_.rate(), dt_s);
}

void Driver::update(const WorldState& world, double dt_s) {
  const Command c = command(world);
  stick_x_.follow(c.x, dt_s);
  stick_y_.follow(c.y, dt_s);
  twist_.follow(c.twist, dt_s);
  brake_.follow(c.brake, dt_s);
  boost_.follow(c.boost, dt_s);
  answerAcceleration(world, dt_s);
}

}  // namespace coherency
