#include "common/body/ArmKinematics.h"

#include <numbers>

#include "common/math/Trigonometry.h"

namespace coherency {

namespace {

const Coord3 kAlong{1.0, 0.0, 0.0};                           // a segment, in the T-pose
const Coord3 kElbowHinge{0.0, std::numbers::sqrt3 / 2, 0.5};  // in the T-pose

TransformMatrix tiltedBase(double tilt_up, double tilt_back) {
  const SineCosine up = sineCosine(tilt_up);
  const SineCosine back = sineCosine(tilt_back);
  const Coord3 a1{up.cosine * back.cosine, up.sine, up.cosine * back.sine};
  const Coord3 a2{-back.sine, 0.0, back.cosine};
  const Coord3 a3{-up.sine * back.cosine, up.cosine, -up.sine * back.sine};
  return TransformMatrix::fromAxes(a1, a3, a2);
}

/// From the T-pose to the hanging arm: along -> -y, hinge -> +x.
TransformMatrix hangingFromT() {
  const auto t_pose = TransformMatrix::fromAxes(kAlong, kElbowHinge, cross(kAlong, kElbowHinge));
  const auto hanging = TransformMatrix::fromAxes({0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
  return hanging * t_pose.rigidInverse();
}

}  // namespace

ArmKinematics::ArmKinematics(const Rig& rig)
    : base_(tiltedBase(rig.shoulder_tilt_up, rig.shoulder_tilt_back)),
      hang_(hangingFromT()),
      upper_arm_(rig.upper_arm),
      forearm_(rig.forearm),
      hand_(rig.hand) {}

TransformMatrix ArmKinematics::hingeFrame() {
  return TransformMatrix::fromAxes(kAlong, cross(kElbowHinge, kAlong), kElbowHinge);
}

ArmPose ArmKinematics::pose(const ArmJoints& j) const {
  ArmPose p;
  p.t_shoulder_flexed = base_ * TransformMatrix::rotationX(j[0]);
  p.t_shoulder_abducted = p.t_shoulder_flexed * TransformMatrix::rotationZ(j[1]);
  p.t_shoulder_upper = p.t_shoulder_abducted * TransformMatrix::rotationY(j[2]) * hang_;
  p.t_shoulder_bent = p.t_shoulder_upper * TransformMatrix::rotation(kElbowHinge, j[3]);
  p.t_shoulder_forearm = p.t_shoulder_bent * TransformMatrix::rotationX(j[4]);
  p.t_shoulder_deviated = p.t_shoulder_forearm * TransformMatrix::rotationY(j[6]);
  p.t_shoulder_hand = p.t_shoulder_deviated * TransformMatrix::rotationZ(j[5]);
  const Coord3 elbow = p.t_shoulder_upper.vector(kAlong * upper_arm_);
  const Coord3 wrist = elbow + p.t_shoulder_forearm.vector(kAlong * forearm_);
  p.t_shoulder_bent.setOrigin(elbow);
  p.t_shoulder_forearm.setOrigin(elbow);
  p.t_shoulder_deviated.setOrigin(wrist);
  p.t_shoulder_hand.setOrigin(wrist);
  p.palm = p.t_shoulder_hand.point(kAlong * hand_);
  return p;
}

ArmJoints armJoints(const MotionSample& sample) {
  ArmJoints joints{};
  for (std::size_t i = 0; i < kArmJointCount; ++i)
    joints[i] = sample.si(dofAt(index(Dof::ShoulderFlexion) + i));
  return joints;
}

}  // namespace coherency
