#pragma once

#include <array>
#include <span>

#include "common/body/Rig.h"
#include "common/math/TransformMatrix.h"
#include "common/motion/MotionSample.h"

namespace coherency {

using ArmJoints = std::array<double, kArmJointCount>;  ///< j1..j7, radians, in DOF order

/// Frames of the right arm relative to the shoulder: the frame at the shoulder joint with the thorax's axes.
/// Each segment's x axis runs along it away from the body. The hand frame's origin is the wrist; -y leaves
/// the palm, -z points to the thumb's side. Between the segments are the frames that mechanisms need which
/// have the seven joints one by one.
struct ArmPose {
  TransformMatrix t_shoulder_flexed;    ///< base turned by j1, about x; origin: shoulder joint
  TransformMatrix t_shoulder_abducted;  ///< then by j2, about z; j3 turns about its y
  TransformMatrix t_shoulder_upper;     ///< origin: shoulder joint
  TransformMatrix t_shoulder_bent;      ///< upper arm turned by j4; origin: elbow
  TransformMatrix t_shoulder_forearm;   ///< origin: elbow
  TransformMatrix t_shoulder_deviated;  ///< forearm turned by j7; origin: wrist
  TransformMatrix t_shoulder_hand;      ///< origin: wrist
  Coord3 palm;                          ///< middle of the palm, in the shoulder frame
};

/// The seven-joint right arm of the exoskeletal master. Away from the T-pose (arm along +x, palm down) the
/// hand turns by
///   R = T Rx(j1) Rz(j2) Ry(j3) H0 R(h, j4) Rx(j5) Ry(j7) Rz(j6),  h = (0, sqrt(3)/2, 1/2),
/// T = [A1 | A3 | A2] the base tilted up and back by the rig's angles, so that the singularity (upper arm
/// along +-A1) stays out of reach, and H0 the turn from the T-pose to the hanging arm with the elbow's hinge
/// along +x. Positive: j1 raise forward, j2 away from the body, j3 turn the upper arm inward, j4 bend the
/// elbow, j5 supinate, j6 extend the wrist, j7 radial deviation. Joint limits are the DOF table's.
class ArmKinematics {
 public:
  explicit ArmKinematics(const Rig& rig);

  ArmPose pose(const ArmJoints& joints) const;
  /// T of the text above: x is the axis of j1.
  const TransformMatrix& base() const { return base_; }
  /// A frame about the upper arm's x, or the bent frame's, whose z runs along the elbow's hinge.
  static TransformMatrix hingeFrame();

  struct Solution {
    ArmJoints joints;
    double position_error_m;  ///< palm to its target
    double angle_error_rad;   ///< hand's attitude to its target; 0 if none was asked
  };
  /// Joints within limits that bring the palm's middle to `palm`, near `seed` (damped least squares, Wampler
  /// 1986). With `orientation` the hand's axes are brought there too, the palm's place coming first. Where
  /// the way from the seed ends short of the place, a few other postures are tried. What cannot be reached is
  /// approached; the errors say how far.
  Solution solve(const Coord3& palm, const TransformMatrix* orientation, const ArmJoints& seed) const;

 private:
  Solution descend(const Coord3& palm, const TransformMatrix* orientation, const ArmJoints& seed) const;

  TransformMatrix base_;
  TransformMatrix hang_;
  double upper_arm_;
  double forearm_;
  double hand_;
};

ArmJoints armJoints(const MotionSample& sample);

}  // namespace coherency
