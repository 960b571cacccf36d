#pragma once

#include "motion_server/device/simulated/MinimumJerk.h"
#include "motion_server/device/simulated/ReachPlanner.h"
#include "motion_server/device/simulated/Variation.h"

namespace coherency {

/// The right arm at work, with the trunk that follows it and the hand that opens and closes.
class Arm {
 public:
  explicit Arm(const Rig& rig);

  /// Each starts one reach and returns how long it takes, in seconds. A reach begins where the last one
  /// ended: call them when it has.
  double reachTo(const Coord3& palm_body, double width_m, double time_s, Chance& chance);
  double goToRest(double time_s, Chance& chance);
  void closeTo(double grip, double time_s, double duration_s) {
    grip_ = grip_.redirected(grip, time_s, duration_s);
  }

  ReachPose at(double time_s) const { return reach_.at(progress_.at(time_s).position); }
  double grip(double time_s) const { return grip_.at(time_s).position; }
  const ReachPlanner& planner() const { return planner_; }

 private:
  double start(Reach reach, double distance_m, double width_m, double time_s, Chance& chance);

  ReachPlanner planner_;
  Reach reach_;
  MinimumJerk progress_;
  MinimumJerk grip_;
};

inline constexpr double kRelaxedGrip = 0.25;

}  // namespace coherency
