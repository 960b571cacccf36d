#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/FixedPoint.h"
#include "common/math/TransformMatrix.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kQuarter = kTurn / 4.0;

void expectNear(const Coord3& a, const Coord3& b, double tolerance = 1e-15) {
  EXPECT_LE(norm(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y
                                    << ' ' << b.z;
}

double largestElement(const TransformMatrix& m) {
  return largestDifference(m, 0.0 * m);
}

TEST(TransformMatrix, StartsAsIdentity) {
  const TransformMatrix m;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) EXPECT_EQ(m(row, column), row == column ? 1.0 : 0.0);
}

TEST(TransformMatrix, TranslationMovesPointsAndNotDirections) {
  const TransformMatrix t = TransformMatrix::translation({1.0, 2.0, 3.0});
  EXPECT_EQ(t.point({10.0, 20.0, 30.0}), Coord3(11.0, 22.0, 33.0));
  EXPECT_EQ(t.vector({10.0, 20.0, 30.0}), Coord3(10.0, 20.0, 30.0));
  EXPECT_EQ(t.origin(), Coord3(1.0, 2.0, 3.0));
  EXPECT_EQ(t(1, 3), 2.0);
  EXPECT_EQ(t.linear(), TransformMatrix());
}

TEST(TransformMatrix, RotationsAreRightHanded) {
  expectNear(TransformMatrix::rotationX(kQuarter).vector({0, 1, 0}), {0, 0, 1});
  expectNear(TransformMatrix::rotationY(kQuarter).vector({0, 0, 1}), {1, 0, 0});
  expectNear(TransformMatrix::rotationZ(kQuarter).vector({1, 0, 0}), {0, 1, 0});
}

RC_GTEST_PROP(TransformMatrix, RotationAboutAnAxisAgreesWithTheCoordinateRotations, ()) {
  const double a = random::real(-10.0, 10.0);
  const double length = random::real(1e-3, 1e3);
  RC_ASSERT(largestDifference(TransformMatrix::rotation({length, 0, 0}, a), TransformMatrix::rotationX(a)) <
            1e-15);
  RC_ASSERT(largestDifference(TransformMatrix::rotation({0, length, 0}, a), TransformMatrix::rotationY(a)) <
            1e-15);
  RC_ASSERT(largestDifference(TransformMatrix::rotation({0, 0, length}, a), TransformMatrix::rotationZ(a)) <
            1e-15);
}

RC_GTEST_PROP(TransformMatrix, RotationKeepsItsAxisAndIsRigid, ()) {
  const Coord3 axis = random::direction();
  const TransformMatrix r = TransformMatrix::rotation(axis, random::angle());
  RC_ASSERT(norm(r.vector(axis) - axis) < 1e-15);
  RC_ASSERT(r.isRigid(1e-14));
}

TEST(TransformMatrix, RotationAboutNothingIsRefused) {
  EXPECT_THROW(TransformMatrix::rotation({}, 1.0), std::domain_error);
}

TEST(TransformMatrix, AxesAreColumns) {
  const TransformMatrix m = TransformMatrix::fromAxes({1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12});
  EXPECT_EQ(m.vector({1, 0, 0}), Coord3(1, 2, 3));
  EXPECT_EQ(m.vector({0, 1, 0}), Coord3(4, 5, 6));
  EXPECT_EQ(m.vector({0, 0, 1}), Coord3(7, 8, 9));
  EXPECT_EQ(m.point({}), Coord3(10, 11, 12));
  EXPECT_EQ(m(2, 1), 6.0);
  EXPECT_EQ(TransformMatrix::scaling({2, 3, 4}).point({1, 1, 1}), Coord3(2, 3, 4));
}

TEST(TransformMatrix, SumDifferenceAndScalarsWorkByElement) {
  const TransformMatrix a = TransformMatrix::translation({1, 2, 3});
  const TransformMatrix b = TransformMatrix::scaling({5, 6, 7});
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      EXPECT_EQ((a + b)(row, column), a(row, column) + b(row, column));
      EXPECT_EQ((a - b)(row, column), a(row, column) - b(row, column));
      EXPECT_EQ((a * 3.0)(row, column), a(row, column) * 3.0);
      EXPECT_EQ((3.0 * a)(row, column), a(row, column) * 3.0);
      EXPECT_EQ((a / 4.0)(row, column), a(row, column) / 4.0);
    }
  EXPECT_THROW(a / 0.0, std::domain_error);
}

RC_GTEST_PROP(TransformMatrix, ProductAppliesTheRightFactorFirst, ()) {
  const TransformMatrix a = random::affine(10.0);
  const TransformMatrix b = random::affine(10.0);
  const Coord3 p = random::vector(10.0);
  const double size = (1.0 + a.maxScale()) * (1.0 + b.maxScale()) * 100.0;
  RC_ASSERT(norm((a * b).point(p) - a.point(b.point(p))) < 1e-15 * size);
}

RC_GTEST_PROP(TransformMatrix, ProductIsAssociative, ()) {
  const TransformMatrix a = random::affine(10.0);
  const TransformMatrix b = random::affine(10.0);
  const TransformMatrix c = random::affine(10.0);
  const double size = largestElement(a) * largestElement(b) * largestElement(c) + 1.0;
  RC_ASSERT(largestDifference((a * b) * c, a * (b * c)) < 1e-14 * size);
}

RC_GTEST_PROP(Inverse, TimesTheMatrixIsIdentity, ()) {
  const TransformMatrix m = random::affine(10.0);
  const TransformMatrix i = m.inverse();
  const double rounding = 1e-15 * 16.0 * largestElement(m) * largestElement(i);
  RC_ASSERT(largestDifference(i * m, {}) < rounding);
  RC_ASSERT(largestDifference(m * i, {}) < rounding);
}

RC_GTEST_PROP(Inverse, UndoesAProjectiveTransformToo, ()) {
  TransformMatrix m = random::affine(1.0);
  m(3, 0) = random::real(-1.0, 1.0);
  m(3, 2) = -1.0;
  m(3, 3) = 0.0;
  try {
    const TransformMatrix i = m.inverse(1e6);
    RC_ASSERT(largestDifference(i * m, {}) < 1e-8);
  } catch (const std::domain_error&) {
    RC_DISCARD("badly conditioned");
  }
}

RC_GTEST_PROP(Inverse, OfRotationAndTranslationIsTheRigidInverse, ()) {
  const TransformMatrix m = random::rigid(1e4);
  RC_ASSERT(m.isRigid());
  RC_ASSERT(m.rigidInverse().isRigid());
  RC_ASSERT(largestDifference(m.inverse(), m.rigidInverse()) < 1e-10);
  RC_ASSERT(largestDifference(m.rigidInverse() * m, {}) < 1e-10);
  RC_ASSERT(m.rigidInverse().rigidInverse().linear() == m.linear());  // a transpose loses nothing
}

/// Returns the message with which the inverse is refused.
std::string refusalOf(const TransformMatrix& m, double max_condition = 1e12) {
  try {
    const TransformMatrix i = m.inverse(max_condition);
    return i.isFinite() ? "" : "returned a value that is not finite";
  } catch (const std::domain_error& error) {
    return error.what();
  }
}

TEST(Inverse, RefusesSingularMatricesAndNamesTheCondition) {
  TransformMatrix equal_rows = TransformMatrix::fromAxes({1, 1, 0}, {2, 2, 0}, {0, 0, 1});
  EXPECT_NE(refusalOf(equal_rows).find("condition number inf"), std::string::npos) << refusalOf(equal_rows);
  EXPECT_NE(refusalOf(TransformMatrix::scaling({1, 0, 1})).find("condition number"), std::string::npos);
  EXPECT_NE(refusalOf(0.0 * TransformMatrix()).find("condition number"), std::string::npos);
}

TEST(Inverse, RefusesIllConditionedMatricesAtTheLimitAskedFor) {
  const TransformMatrix m = TransformMatrix::scaling({1.0, 1e-8, 1.0});
  EXPECT_EQ(refusalOf(m), "");
  EXPECT_NE(refusalOf(m, 1e7).find("1e+08"), std::string::npos) << refusalOf(m, 1e7);
  EXPECT_NE(refusalOf(TransformMatrix::scaling({1.0, 1e-13, 1.0})), "");
  TransformMatrix nearly_singular = TransformMatrix::fromAxes({1, 1, 0}, {1, 1.0 + 1e-14, 0}, {0, 0, 1});
  EXPECT_NE(refusalOf(nearly_singular), "");
}

TEST(Inverse, RefusesWhatIsNotFinite) {
  for (const double bad : {kNan, kInfinity, -kInfinity})
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) {
        TransformMatrix m;
        m(row, column) = bad;
        EXPECT_NE(refusalOf(m).find("not finite"), std::string::npos) << row << ' ' << column;
        EXPECT_FALSE(m.isFinite());
        EXPECT_FALSE(m.isRigid());
      }
}

RC_GTEST_PROP(Inverse, NeverReturnsNan, ()) {
  TransformMatrix m;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      m(row, column) = *rc::gen::inRange(0, 3) == 0 ? 0.0 : random::magnitude(-320.0, 308.0);
  try {
    RC_ASSERT(m.inverse(kInfinity).isFinite());
  } catch (const std::domain_error&) {
    RC_SUCCEED("refused");
  }
}

TEST(Inverse, NeitherDistanceNorUnitMakesAFrameSingular) {
  const TransformMatrix far =
      TransformMatrix::translation({1e13, -1e13, 3.0}) * TransformMatrix::rotationY(0.3);
  EXPECT_LT(norm(far.inverse().point(far.origin())), 1e-2);
  const TransformMatrix nanometres = TransformMatrix::scaling({1e-9, 1e-9, 1e-9});
  EXPECT_NEAR(nanometres.inverse()(0, 0), 1e9, 1e-6);
}

TEST(Rigid, MeansRotationAndTranslationOnly) {
  EXPECT_TRUE((TransformMatrix::translation({1, 2, 3}) * TransformMatrix::rotationX(1.0)).isRigid());
  EXPECT_FALSE(TransformMatrix::scaling({1, 1, 1.001}).isRigid());
  EXPECT_TRUE(TransformMatrix::scaling({1, 1, 1.001}).isRigid(0.01));
  EXPECT_FALSE(TransformMatrix::scaling({-1, 1, 1}).isRigid());  // a mirror
  TransformMatrix shear;
  shear(0, 1) = 0.01;
  EXPECT_FALSE(shear.isRigid());
  TransformMatrix projective;
  projective(3, 2) = 1e-12;
  EXPECT_FALSE(projective.isRigid());
}

}  // namespace
}  // namespace coherency
