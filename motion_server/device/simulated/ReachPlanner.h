#pragma once

#include <vector>

#include "common/body/ArmKinematics.h"
#include "motion_server/device/simulated/SeatedBody.h"

namespace coherency {

/// Trunk and right arm together: what a reach moves.
struct ReachPose {
  Lean lean;
  ArmJoints joints{};
};

/// A way from one pose to another, s from 0 to 1; two times continuously differentiable, its ends exact.
class Reach {
 public:
  /// Precondition: at least two poses.
  explicit Reach(std::vector<ReachPose> poses) : poses_(std::move(poses)) {}
  ReachPose at(double s) const;
  const ReachPose& goal() const { return poses_.back(); }

 private:
  std::vector<ReachPose> poses_;
};

/// Plans reaches as people make them: the palm goes nearly straight, rises early and sinks late, and the
/// trunk leans as far as the arm alone does not reach.
class ReachPlanner {
 public:
  explicit ReachPlanner(const Rig& rig);

  /// Brings the middle of the palm to `palm` (body frame), palm down; as near as body and arm reach.
  Reach toPlace(const ReachPose& from, const Coord3& palm) const;
  /// Upright again, the hand back on the thigh.
  Reach toRest(const ReachPose& from) const;

  /// Where the palm must be for something that is `in_hand` (m, hand's axes, from the middle of the palm) to
  /// be at `place` (body frame), when the hand takes the attitude that toPlace() gives it.
  Coord3 palmFor(const Coord3& place, const Coord3& in_hand) const;
  /// T_body_hand.
  TransformMatrix hand(const ReachPose& pose) const;

  /// How far the arm is stretched when the palm is there and the trunk leans as it does: the palm's distance
  /// from the shoulder over the straight arm's length. Beyond 1 it is out of reach.
  double stretch(const Coord3& palm) const;

  ReachPose rest() const { return rest_; }
  Coord3 palm(const ReachPose& pose) const;  ///< body frame
  const SeatedBody& body() const { return body_; }
  /// Straight, from the shoulder to the middle of the palm, m.
  double armLength() const;

  /// Fitts' law (Shannon form): seconds for a movement of `distance_m` that ends within `width_m`.
  static double duration(double distance_m, double width_m);

 private:
  struct Waypoint {
    Coord3 palm;      // body frame
    Quaternion hand;  // its attitude, body frame
    Lean lean;
  };
  Waypoint waypoint(const ReachPose& pose) const;
  static Waypoint between(const Waypoint& start, const Waypoint& goal, double s);
  ReachPose poseAt(const Waypoint& way, const ArmJoints& seed) const;
  Lean leanFor(const Coord3& palm) const;
  Quaternion attitudeAt(const Coord3& palm) const;

  SeatedBody body_;
  ArmKinematics arm_;
  ReachPose rest_;
};

}  // namespace coherency
