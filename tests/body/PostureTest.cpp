#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/body/Posture.h"
#include "common/math/Rotation.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

MotionSample sampleOf(const std::array<double, kDofCount>& si) {
  MotionSample sample;
  for (std::size_t i = 0; i < kDofCount; ++i) sample.units[i] = unitsFromSi(dofTable()[i].kind, si[i]);
  return sample;
}

TEST(Posture, NeutralSitsUpright) {
  const Rig rig;
  const Posture p = posture(rig, ArmKinematics(rig), sampleOf(neutralPosture(rig)));
  EXPECT_LT(norm(p.t_body_head.origin() - neutralHead(rig)), 1e-6);
  EXPECT_LT(norm(p.t_body_thorax.origin() - Coord3(0, rig.seat_height + rig.trunk_length, 0)), 1e-6);
  EXPECT_NEAR(p.trunk_stretch, 1.0, 1e-5);
  EXPECT_LT(largestDifference(p.t_body_thorax.linear(), TransformMatrix()), 1e-5);
  EXPECT_EQ(p.hip, Coord3(0, rig.seat_height, 0));
}

TEST(Posture, NeutralRestsTheForearmLevelWithThePalmDown) {
  const Rig rig;
  const Posture p = posture(rig, ArmKinematics(rig), sampleOf(neutralPosture(rig)));
  EXPECT_LT(norm(p.right_arm.t_shoulder_forearm.vector({1, 0, 0}) - Coord3(0, 0, -1)), 1e-6);
  EXPECT_LT(norm(p.right_arm.t_shoulder_hand.vector({0, -1, 0}) - Coord3(0, -1, 0)), 1e-6);
}

RC_GTEST_PROP(Posture, FollowsTheHeadAndStaysRigid, ()) {
  const Rig rig;
  std::array<double, kDofCount> si{};
  for (std::size_t i = 0; i < kDofCount; ++i) si[i] = random::real(dofTable()[i].min, dofTable()[i].max);
  const Posture p = posture(rig, ArmKinematics(rig), sampleOf(si));
  RC_ASSERT(p.t_body_head.isRigid() && p.t_body_thorax.isRigid() && p.t_body_shoulder.isRigid());
  RC_ASSERT(norm(p.t_body_head.origin() - Coord3(si[0], si[1], si[2])) < 1e-5);
  // The neck joins head and trunk, and the trunk points from the hips to it.
  const Coord3 neck = p.t_body_thorax.origin();
  RC_ASSERT(norm(p.t_body_head.rigidInverse().point(neck) - Coord3(0, -rig.neck_length, rig.neck_back)) <
            1e-9);
  const Coord3 along = neck - p.hip;
  RC_ASSERT(norm(p.t_body_thorax.vector({0, norm(along), 0}) - along) < 1e-6);
  RC_ASSERT(std::abs(p.trunk_stretch * rig.trunk_length - norm(along)) < 1e-9);
  RC_ASSERT(norm(p.t_body_thorax.rigidInverse().point(p.t_body_shoulder.origin()) -
                 Coord3(rig.shoulder_half_width, -rig.shoulder_drop, 0)) < 1e-9);
}

TEST(Posture, ANeckInTheHipsGivesNoNan) {
  const Rig rig;
  auto si = neutralPosture(rig);
  si[index(Dof::HeadY)] = rig.seat_height + rig.neck_length;
  const Posture p = posture(rig, ArmKinematics(rig), sampleOf(si));
  EXPECT_TRUE(p.t_body_thorax.isRigid());
}

TEST(Posture, EyesAreApartAndAheadOfTheHead) {
  const Rig rig;
  const Coord3 left = headToEye(rig, -1).origin();
  const Coord3 right = headToEye(rig, 1).origin();
  EXPECT_NEAR(right.x - left.x, rig.eye_distance, 1e-15);
  EXPECT_NEAR(right.x + left.x, 0.0, 1e-15);
  EXPECT_EQ(headToEye(rig, 0).origin(), Coord3(0, rig.eye_up, -rig.eye_forward));
}

RC_GTEST_PROP(TwoBoneLimb, KeepsLengthsAndBendsTowardsThePole, ()) {
  const Coord3 root = random::vector(1.0);
  const Coord3 tip = root + random::direction() * random::real(0.0, 2.0);
  const double first = random::real(0.1, 0.6);
  const double second = random::real(0.1, 0.6);
  const Coord3 pole = random::direction();
  const TwoBoneLimb limb = twoBoneLimb(root, tip, first, second, pole);
  RC_ASSERT(std::abs(norm(limb.joint - root) - first) < 1e-7);
  RC_ASSERT(std::abs(norm(limb.tip_reached - limb.joint) - second) < 1e-7);
  const double span = norm(tip - root);
  if (span < first + second && span > std::abs(first - second))
    RC_ASSERT(norm(limb.tip_reached - tip) < 1e-9);
  if (span > 0.0) {
    const Coord3 along = normalized(tip - root);
    const Coord3 bend = limb.joint - root - along * dot(limb.joint - root, along);
    RC_ASSERT(dot(bend, pole) >= -1e-9);
  }
}

TEST(TwoBoneLimb, IsFiniteWhereNothingIsDetermined) {
  for (const Coord3& tip : {Coord3(0, 0, 0), Coord3(0, 1, 0), Coord3(0, -9, 0)}) {
    const TwoBoneLimb limb = twoBoneLimb({0, 0, 0}, tip, 0.4, 0.4, {0, 1, 0});
    EXPECT_TRUE(isFinite(limb.joint) && isFinite(limb.tip_reached));
    EXPECT_NEAR(norm(limb.joint), 0.4, 1e-9);
  }
}

}  // namespace
}  // namespace coherency
