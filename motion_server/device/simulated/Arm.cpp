#include "motion_server/device/simulated/Arm.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coherency {

namespace {

constexpr double kFastestJoint = 4.5;  // rad/s, of somebody not in a hurry

/// Peak rate of any joint when the reach takes a second.
double fastestJoint(const Reach& reach) {
  constexpr int kSamples = 32;
  double fastest = 0.0;
  ReachPose before = reach.at(0.0);
  for (int i = 1; i <= kSamples; ++i) {
    const ReachPose pose = reach.at(minimumJerk(static_cast<double>(i) / kSamples));
    for (std::size_t j = 0; j < kArmJointCount; ++j) {
      fastest = std::max(fastest, std::abs(pose.joints[j] - before.joints[j]) * kSamples);
    }
    before = pose;
  }
  return fastest;
}

}  // namespace

Arm::Arm(const Rig& rig)
    : planner_(rig), reach_({planner_.rest(), planner_.rest()}), progress_(1.0), grip_(kRelaxedGrip) {}

double Arm::start(Reach reach, double distance_m, double width_m, double time_s, Chance& chance) {
  const double unhurried =
      std::max(ReachPlanner::duration(distance_m, width_m), fastestJoint(reach) / kFastestJoint);
  const double duration = unhurried * chance.between(0.9, 1.2);
  reach_ = std::move(reach);
  progress_ = MinimumJerk({}, 1.0, time_s, duration);
  return duration;
}

double Arm::reachTo(const Coord3& palm_body, double width_m, double time_s, Chance& chance) {
  const ReachPose now = at(time_s);
  const double distance = norm(palm_body - planner_.palm(now));
  return start(planner_.toPlace(now, palm_body), distance, width_m, time_s, chance);
}

double Arm::goToRest(double time_s, Chance& chance) {
  const ReachPose now = at(time_s);
  const double distance = norm(planner_.palm(planner_.rest()) - planner_.palm(now));
  return start(planner_.toRest(now), distance, 0.03, time_s, chance);
}

}  // namespace coherency
