#include "motion_server/device/simulated/MinimumJerk.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace coherency {

double minimumJerk(double s) {
  const double t = std::clamp(s, 0.0, 1.0);
  return t * t * t * (10.0 + t * (-15.0 + t * 6.0));
}

MinimumJerk::MinimumJerk(const State& from, double goal, double start_s, double duration_s)
    : start_(start_s), duration_(duration_s) {
  assert(duration_s > 0.0);
  const double way = goal - from.position;
  const double v = from.velocity * duration_s;
  const double a = from.acceleration * duration_s * duration_s;
  coefficients_ = {from.position,
                   v,
                   a / 2.0,
                   10.0 * way - 6.0 * v - 1.5 * a,
                   -15.0 * way + 8.0 * v + 1.5 * a,
                   6.0 * way - 3.0 * v - 0.5 * a};
}

MinimumJerk::State MinimumJerk::at(double time_s) const {
  const double s = std::clamp((time_s - start_) / duration_, 0.0, 1.0);
  const auto& c = coefficients_;
  State state;
  for (std::size_t i = c.size(); i-- > 0;) {
    state.acceleration = state.acceleration * s + 2.0 * state.velocity;
    state.velocity = state.velocity * s + state.position;
    state.position = state.position * s + c[i];
  }
  if (time_s >= end()) return {state.position, 0.0, 0.0};
  return {state.position, state.velocity / duration_, state.acceleration / (duration_ * duration_)};
}

void Follower::follow(double goal, double dt_s) {
  const double error = value_ - goal;
  const double slope = rate_ + bandwidth_ * error;
  const double decay = std::exp(-bandwidth_ * dt_s);
  value_ = goal + (error + slope * dt_s) * decay;
  rate_ = (rate_ - bandwidth_ * slope * dt_s) * decay;
}

}  // namespace coherency
