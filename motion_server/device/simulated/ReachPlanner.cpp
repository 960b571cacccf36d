#include "motion_server/device/simulated/ReachPlanner.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "motion_server/device/simulated/Variation.h"

namespace coherency {

namespace {

constexpr int kSteps = 8;               // poses a reach is planned through
constexpr double kComfortable = 0.88;   // of the straight arm
constexpr double kFarthestLean = 1.05;  // rad
constexpr double kLeanStep = 0.025;
constexpr double kSideShare = 0.5;  // one leans less to the side than ahead
constexpr double kHandDown = 0.35;  // rad, fingers below the horizontal when grasping
constexpr double kRestLean = 0.03;  // rad
constexpr double kThighTop = 0.11;  // m, palm of a hand on the thigh, above the hip joint
constexpr double kMargin = 0.03;    // rad, kept from the joints' limits

double joint(const ReachPose& pose, std::size_t i) {
  return i < kArmJointCount ? pose.joints[i] : i == kArmJointCount ? pose.lean.forward : pose.lean.right;
}
double& joint(ReachPose& pose, std::size_t i) {
  return i < kArmJointCount ? pose.joints[i] : i == kArmJointCount ? pose.lean.forward : pose.lean.right;
}

/// Palm down, fingers from the shoulder towards the palm's place; body frame.
Quaternion grasp(const Coord3& shoulder_to_palm) {
  const double yaw = std::atan2(-shoulder_to_palm.x, -shoulder_to_palm.z);
  const auto ahead = TransformMatrix::fromAxes({0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0});
  return quaternion(TransformMatrix::rotationY(yaw) * ahead * TransformMatrix::rotationZ(-kHandDown));
}

}  // namespace

ReachPose Reach::at(double s) const {
  const auto last = static_cast<std::ptrdiff_t>(poses_.size()) - 1;
  const double position = std::clamp(s, 0.0, 1.0) * static_cast<double>(last);
  const auto n = std::min(static_cast<std::ptrdiff_t>(position), last - 1);
  const auto control = [&](std::ptrdiff_t i, std::size_t j) {
    // A point beyond either end mirrors the one within, so that the spline begins and ends in its end points.
    if (i < 0) return 2.0 * joint(poses_[0], j) - joint(poses_[1], j);
    if (i > last) return 2.0 * joint(poses_.back(), j) - joint(poses_[poses_.size() - 2], j);
    return joint(poses_[static_cast<std::size_t>(i)], j);
  };
  ReachPose pose;
  for (std::size_t j = 0; j < kArmJointCount + 2; ++j) {
    joint(pose, j) = cubicBSpline(control(n - 1, j), control(n, j), control(n + 1, j), control(n + 2, j),
                                  position - static_cast<double>(n));
  }
  return pose;
}

ReachPlanner::ReachPlanner(const Rig& rig) : body_(rig), arm_(rig) {
  const auto neutral = neutralPosture(rig);
  ArmJoints level{};
  for (std::size_t j = 0; j < kArmJointCount; ++j) level[j] = neutral[index(Dof::ShoulderFlexion) + j];
  const Lean lean{kRestLean, 0.0};
  const Waypoint lap{{rig.hip_half_width + 0.04, rig.seat_height + kThighTop, -0.55 * rig.thigh},
                     grasp({0.0, 0.0, -1.0}),
                     lean};
  rest_ = poseAt(lap, level);
}

Coord3 ReachPlanner::palm(const ReachPose& pose) const {
  return body_.shoulder(pose.lean).point(arm_.pose(pose.joints).palm);
}

Coord3 ReachPlanner::palmFor(const Coord3& place, const Coord3& in_hand) const {
  Coord3 palm = place;
  for (int i = 0; i < 3; ++i)  // the attitude depends a little on the place
    palm = place - rotation(attitudeAt(palm)).vector(in_hand);
  return palm;
}

TransformMatrix ReachPlanner::hand(const ReachPose& pose) const {
  return body_.shoulder(pose.lean) * arm_.pose(pose.joints).t_shoulder_hand;
}

double ReachPlanner::armLength() const {
  const Rig& rig = body_.rig();
  return rig.upper_arm + rig.forearm + rig.hand;
}

Quaternion ReachPlanner::attitudeAt(const Coord3& palm) const {
  return grasp(palm - body_.shoulder(leanFor(palm)).origin());
}

double ReachPlanner::stretch(const Coord3& palm) const {
  return norm(palm - body_.shoulder(leanFor(palm)).origin()) / armLength();
}

Lean ReachPlanner::leanFor(const Coord3& palm) const {
  const double comfortable = kComfortable * armLength();
  const double azimuth = std::atan2(palm.x, -palm.z);
  Lean best = rest_.lean;
  double least = std::numeric_limits<double>::infinity();
  const int steps = static_cast<int>((kFarthestLean - kRestLean) / kLeanStep);
  for (int i = 0; i <= steps && least > comfortable; ++i) {
    const double angle = kRestLean + i * kLeanStep;
    const Lean lean{angle * std::cos(azimuth), kSideShare * angle * std::sin(azimuth)};
    if (const double far = norm(palm - body_.shoulder(lean).origin()); far < least) least = far, best = lean;
  }
  return best;
}

ReachPlanner::Waypoint ReachPlanner::waypoint(const ReachPose& pose) const {
  const TransformMatrix shoulder = body_.shoulder(pose.lean);
  return {palm(pose), quaternion((shoulder * arm_.pose(pose.joints).t_shoulder_hand).linear()), pose.lean};
}

ReachPlanner::Waypoint ReachPlanner::between(const Waypoint& start, const Waypoint& goal, double s) {
  const double rising = 1.0 - std::pow(1.0 - s, 4);  // over a table's edge before going far
  const double sinking = std::pow(s, 4);
  Waypoint way;
  way.palm = start.palm + (goal.palm - start.palm) * s;
  way.palm.y = start.palm.y + (goal.palm.y - start.palm.y) * (goal.palm.y > start.palm.y ? rising : sinking);
  way.hand = slerp(start.hand, goal.hand, s);
  way.lean = {start.lean.forward + (goal.lean.forward - start.lean.forward) * s,
              start.lean.right + (goal.lean.right - start.lean.right) * s};
  return way;
}

ReachPose ReachPlanner::poseAt(const Waypoint& way, const ArmJoints& seed) const {
  const TransformMatrix shoulder = body_.shoulder(way.lean);
  const TransformMatrix hand = shoulder.linear().rigidInverse() * rotation(way.hand);
  ReachPose pose{way.lean, arm_.solve(shoulder.rigidInverse().point(way.palm), &hand, seed).joints};
  for (std::size_t j = 0; j < kArmJointCount; ++j) {
    const DofInfo& limit = dofTable()[index(Dof::ShoulderFlexion) + j];
    pose.joints[j] = std::clamp(pose.joints[j], limit.min + kMargin, limit.max - kMargin);
  }
  return pose;
}

Reach ReachPlanner::toPlace(const ReachPose& from, const Coord3& place) const {
  const Waypoint start = waypoint(from);
  const Lean lean = leanFor(place);
  const Waypoint goal{place, attitudeAt(place), lean};
  std::vector<ReachPose> poses = {from};
  for (int k = 1; k <= kSteps; ++k) {
    poses.push_back(poseAt(between(start, goal, static_cast<double>(k) / kSteps), poses.back().joints));
  }
  return Reach(std::move(poses));
}

Reach ReachPlanner::toRest(const ReachPose& from) const {
  const Waypoint start = waypoint(from);
  const Waypoint goal = waypoint(rest_);
  std::vector<ReachPose> poses = {from};
  for (int k = 1; k < kSteps; ++k) {
    const double s = static_cast<double>(k) / kSteps;
    ReachPose pose = poseAt(between(start, goal, s), poses.back().joints);
    // Seven joints reach one place in many ways; the way ends in the one that is restful.
    for (std::size_t j = 0; j < kArmJointCount; ++j)
      pose.joints[j] += (rest_.joints[j] - pose.joints[j]) * s * s;
    poses.push_back(pose);
  }
  poses.push_back(rest_);
  return Reach(std::move(poses));
}

double ReachPlanner::duration(double distance_m, double width_m) {
  assert(width_m > 0.0);
  return 0.25 + 0.13 * std::log2(distance_m / width_m + 1.0);
}

}  // namespace coherency
