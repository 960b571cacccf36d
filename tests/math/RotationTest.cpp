#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/FixedPoint.h"
#include "common/math/Rotation.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

constexpr double kQuarter = kTurn / 4.0;
const Coord3 kAhead{0.0, 0.0, -1.0};

Quaternion randomQuaternion() {
  return quaternion(random::rotationMatrix());
}
Quaternion negative(const Quaternion& q) {
  return {-q.x, -q.y, -q.z, -q.w};
}
double norm(const Quaternion& q) {
  return std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
}

/// Angle of the rotation that takes `a` to `b`, exact also where it is small.
double angleBetween(const TransformMatrix& a, const TransformMatrix& b) {
  const Quaternion q = quaternion(a.rigidInverse() * b);
  return 2.0 * std::atan2(std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z), std::abs(q.w));
}

TEST(YawPitchRoll, TurnsLeftLooksUpAndTiltsTheRightSideUp) {
  EXPECT_LT(rotation(YawPitchRoll{0.1, 0.0, 0.0}).vector(kAhead).x, 0.0);
  EXPECT_GT(rotation(YawPitchRoll{0.0, 0.1, 0.0}).vector(kAhead).y, 0.0);
  EXPECT_GT(rotation(YawPitchRoll{0.0, 0.0, 0.1}).vector({1.0, 0.0, 0.0}).y, 0.0);
}

TEST(YawPitchRoll, IsYawThenPitchThenRoll) {
  const TransformMatrix r =
      TransformMatrix::rotationY(0.3) * TransformMatrix::rotationX(-0.4) * TransformMatrix::rotationZ(0.5);
  EXPECT_LT(largestDifference(rotation(YawPitchRoll{0.3, -0.4, 0.5}), r), 1e-15);
}

RC_GTEST_PROP(YawPitchRoll, AnglesComeBack, ()) {
  const YawPitchRoll angles{random::angle(), random::real(-1.5, 1.5), random::angle()};
  const YawPitchRoll back = yawPitchRoll(rotation(angles));
  RC_ASSERT(std::abs(back.yaw - angles.yaw) < 1e-13);
  RC_ASSERT(std::abs(back.pitch - angles.pitch) < 1e-13);
  RC_ASSERT(std::abs(back.roll - angles.roll) < 1e-13);
}

void expectAttitudeComesBack(const YawPitchRoll& angles) {
  const TransformMatrix r = rotation(angles);
  const YawPitchRoll back = yawPitchRoll(r);
  RC_ASSERT(std::abs(back.pitch) <= kQuarter);
  RC_ASSERT(std::abs(back.yaw) <= 2.0 * kQuarter);
  RC_ASSERT(std::abs(back.roll) <= 2.0 * kQuarter);
  RC_ASSERT(largestDifference(rotation(back), r) < 1e-13);
}

RC_GTEST_PROP(YawPitchRoll, AttitudeComesBackForAnyAngles, ()) {
  expectAttitudeComesBack({random::real(-20.0, 20.0), random::real(-20.0, 20.0), random::real(-20.0, 20.0)});
}

RC_GTEST_PROP(YawPitchRoll, AttitudeComesBackBesideStraightUpAndDown, ()) {
  const double pole = *rc::gen::arbitrary<bool>() ? kQuarter : -kQuarter;
  expectAttitudeComesBack({random::angle(), pole + random::magnitude(-17.0, -1.0), random::angle()});
}

/// There yaw and roll are each lost in the rounding of a matrix that comes from anywhere; their sum must not
/// be.
RC_GTEST_PROP(YawPitchRoll, AttitudeComesBackBesideThePolesFromARoundedMatrix, ()) {
  const double pole = *rc::gen::arbitrary<bool>() ? kQuarter : -kQuarter;
  const YawPitchRoll angles{random::angle(), pole + random::magnitude(-17.0, -8.0), random::angle()};
  const TransformMatrix turn = random::rotationMatrix();
  const TransformMatrix r = turn.rigidInverse() * (turn * rotation(angles));
  RC_ASSERT(largestDifference(rotation(yawPitchRoll(r)), r) < 1e-13);
}

TEST(YawPitchRoll, StraightUpAndDownHaveNoRoll) {
  for (const double pitch : {kQuarter, -kQuarter}) {
    const TransformMatrix r = rotation(YawPitchRoll{0.7, pitch, 0.4});
    const YawPitchRoll back = yawPitchRoll(r);
    EXPECT_EQ(back.roll, 0.0);
    EXPECT_DOUBLE_EQ(back.pitch, pitch);
    EXPECT_NEAR(back.yaw, pitch > 0.0 ? 0.3 : 1.1, 1e-13);
    EXPECT_LT(largestDifference(rotation(back), r), 1e-13);
  }
}

RC_GTEST_PROP(Quaternions, MatrixAndQuaternionAreTheSameRotation, ()) {
  const TransformMatrix r = random::rotationMatrix();
  const Quaternion q = quaternion(r);
  RC_ASSERT(std::abs(norm(q) - 1.0) < 1e-15);
  RC_ASSERT(largestDifference(rotation(q), r) < 1e-14);
  RC_ASSERT(largestDifference(rotation(negative(q)), r) < 1e-14);
}

TEST(Quaternions, HalfTurnsAboutEachAxisComeBack) {
  for (const Coord3 axis :
       {Coord3{1, 0, 0}, Coord3{0, 1, 0}, Coord3{0, 0, 1}, Coord3{1, -1, 0}, Coord3{1, 1, 1}}) {
    const TransformMatrix r = TransformMatrix::rotation(axis, kTurn / 2.0);
    EXPECT_LT(largestDifference(rotation(quaternion(r)), r), 1e-15);
    EXPECT_NEAR(quaternion(r).w, 0.0, 1e-15);
  }
}

TEST(Quaternions, ComponentsAreAxisTimesSineAndCosine) {
  const Quaternion q = quaternion(TransformMatrix::rotation({0.0, 0.0, 2.0}, 0.6));
  EXPECT_NEAR(q.z, std::sin(0.3), 1e-15);
  EXPECT_NEAR(q.w, std::cos(0.3), 1e-15);
  EXPECT_EQ(q.x, 0.0);
  EXPECT_EQ(q.y, 0.0);
}

TEST(Quaternions, NormalizeAtEverySizeAndRefuseNothing) {
  for (const double size : {1e-310, 1e-200, 1.0, 1e200, 1e308}) {
    const Quaternion q = normalized(Quaternion{size, -size, size, -size});
    EXPECT_NEAR(q.x, 0.5, 1e-15) << size;
    EXPECT_NEAR(q.w, -0.5, 1e-15) << size;
  }
  EXPECT_THROW(normalized(Quaternion{0.0, 0.0, 0.0, 0.0}), std::domain_error);
  EXPECT_THROW(normalized(Quaternion{0.0, std::nan(""), 0.0, 1.0}), std::domain_error);
  EXPECT_THROW(rotation(Quaternion{0.0, 0.0, 0.0, 0.0}), std::domain_error);
}

RC_GTEST_PROP(Slerp, BeginsAndEndsAtItsEnds, ()) {
  const Quaternion a = randomQuaternion();
  const Quaternion b = randomQuaternion();
  RC_ASSERT(largestDifference(rotation(slerp(a, b, 0.0)), rotation(a)) < 1e-14);
  RC_ASSERT(largestDifference(rotation(slerp(a, b, 1.0)), rotation(b)) < 1e-14);
}

RC_GTEST_PROP(Slerp, GoesAtAnEvenRateAlongTheShortestArc, ()) {
  const Quaternion a = randomQuaternion();
  const Quaternion b = randomQuaternion();
  const double s = random::real(0.0, 1.0);
  const double whole = angleBetween(rotation(a), rotation(b));
  const TransformMatrix between = rotation(slerp(a, b, s));
  RC_ASSERT(whole <= kTurn / 2.0 + 1e-12);
  RC_ASSERT(std::abs(angleBetween(rotation(a), between) - s * whole) < 1e-11);
  RC_ASSERT(std::abs(angleBetween(between, rotation(b)) - (1.0 - s) * whole) < 1e-11);
}

RC_GTEST_PROP(Slerp, SignsOfTheEndsDoNotMatter, ()) {
  const Quaternion a = randomQuaternion();
  const Quaternion b = randomQuaternion();
  const double d = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
  RC_PRE(std::abs(d) > 1e-9);  // half a turn apart both ways round are as short
  const double s = random::real(0.0, 1.0);
  RC_ASSERT(largestDifference(rotation(slerp(a, negative(b), s)), rotation(slerp(a, b, s))) < 1e-13);
}

RC_GTEST_PROP(Slerp, IsWellBehavedAtAnyDistanceOfItsEnds, ()) {
  const Coord3 axis = random::direction();
  const double exponent = random::real(-17.0, 0.0);
  const bool nearly_opposite = *rc::gen::arbitrary<bool>();
  const double angle = nearly_opposite ? kTurn / 2.0 - std::pow(10.0, exponent) : std::pow(10.0, exponent);
  const Quaternion a = randomQuaternion();
  const Quaternion b = quaternion(rotation(a) * TransformMatrix::rotation(axis, angle));
  const double s = random::real(0.0, 1.0);
  const Quaternion between = slerp(a, b, s);
  RC_ASSERT(std::abs(norm(between) - 1.0) < 1e-14);
  RC_ASSERT(std::abs(angleBetween(rotation(a), rotation(between)) - s * angle) < 1e-11);
}

TEST(Slerp, OfEqualEndsIsThatEnd) {
  const Quaternion q = normalized(Quaternion{0.1, -0.2, 0.3, 0.9});
  EXPECT_LT(largestDifference(rotation(slerp(q, q, 0.3)), rotation(q)), 1e-15);
  EXPECT_LT(largestDifference(rotation(slerp(q, negative(q), 0.7)), rotation(q)), 1e-15);
}

void expectSmallestRotation(const Coord3& from, const Coord3& to) {
  const TransformMatrix r = rotationBetween(from, to);
  const Coord3 u = normalized(from);
  const Coord3 v = normalized(to);
  RC_ASSERT(r.isRigid(1e-14));
  RC_ASSERT(norm(r.vector(u) - v) < 1e-14);
  const double smallest = std::atan2(norm(cross(u, v)), dot(u, v));
  RC_ASSERT(std::abs(angleBetween({}, r) - smallest) < 1e-13);
}

RC_GTEST_PROP(RotationBetween, TakesOneDirectionToTheOther, ()) {
  expectSmallestRotation(random::direction() * random::real(1e-3, 1e3), random::direction());
}

RC_GTEST_PROP(RotationBetween, HoldsWhereTheyAreNearlyParallelOrOpposite, ()) {
  const Coord3 from = random::direction();
  const Coord3 to = from + random::direction() * std::pow(10.0, random::real(-20.0, -2.0));
  expectSmallestRotation(from, to);
  expectSmallestRotation(from, -to);
}

TEST(RotationBetween, OppositeDirectionsAreHalfATurnApart) {
  for (const Coord3 axis : {Coord3{1, 0, 0}, Coord3{0, 1, 0}, Coord3{0, 0, -1}, Coord3{1, 2, 3}}) {
    const TransformMatrix r = rotationBetween(axis, -axis);
    EXPECT_TRUE(r.isRigid(1e-15));
    EXPECT_LT(norm(r.vector(axis) + axis), 1e-15);
    EXPECT_NEAR(angleBetween({}, r), kTurn / 2.0, 1e-15);
  }
}

TEST(RotationBetween, EqualDirectionsNeedNone) {
  EXPECT_LT(largestDifference(rotationBetween({1.0, 2.0, -3.0}, {2.0, 4.0, -6.0}), {}), 1e-15);
}

TEST(RotationBetween, RefusesNoDirection) {
  EXPECT_THROW(rotationBetween({}, {1.0, 0.0, 0.0}), std::domain_error);
  EXPECT_THROW(rotationBetween({1.0, 0.0, 0.0}, {}), std::domain_error);
}

}  // namespace
}  // namespace coherency
