#pragma once

#include <array>

namespace coherency {

/// The minimum-jerk course from 0 to 1 as s goes from 0 to 1, at rest at both ends (Flash & Hogan 1985): how
/// people move between two points.
double minimumJerk(double s);

/// Minimum-jerk movement of one quantity from whatever state it is in to rest at a goal. Chained movements
/// are continuous in position, velocity and acceleration.
class MinimumJerk {
 public:
  struct State {
    double position = 0.0;
    double velocity = 0.0;
    double acceleration = 0.0;
  };

  MinimumJerk() = default;
  explicit MinimumJerk(double position) : coefficients_{position} {}
  /// From `from` at `start_s` to rest at `goal`, `duration_s` later. Precondition: duration_s > 0.
  MinimumJerk(const State& from, double goal, double start_s, double duration_s);

  /// Constant before the start and after the end.
  State at(double time_s) const;
  double end() const { return start_ + duration_; }
  /// The movement that leaves this one at `time_s` for another goal.
  MinimumJerk redirected(double goal, double time_s, double duration_s) const {
    return {at(time_s), goal, time_s, duration_s};
  }

 private:
  std::array<double, 6> coefficients_{};
  double start_ = 0.0;
  double duration_ = 1.0;
};

/// A quantity that follows a changing goal as a critically damped second-order system does, integrated
/// exactly for any time step, with no jump in position or velocity.
class Follower {
 public:
  explicit Follower(double bandwidth_rad_s, double value = 0.0)
      : bandwidth_(bandwidth_rad_s), value_(value) {}

  void follow(double goal, double dt_s);
  double value() const { return value_; }
  double rate() const { return rate_; }

 private:
  double bandwidth_;
  double value_;
  double rate_ = 0.0;
};

}  // namespace coherency
