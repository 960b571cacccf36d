#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/Coord3.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Coord3, SumDifferenceAndScalingWorkByCoordinate) {
  const Coord3 a{1.0, 2.0, 3.0};
  const Coord3 b{10.0, -20.0, 0.5};
  EXPECT_EQ(a + b, Coord3(11.0, -18.0, 3.5));
  EXPECT_EQ(a - b, Coord3(-9.0, 22.0, 2.5));
  EXPECT_EQ(-a, Coord3(-1.0, -2.0, -3.0));
  EXPECT_EQ(a * 2.0, Coord3(2.0, 4.0, 6.0));
  EXPECT_EQ(2.0 * a, a * 2.0);
  EXPECT_EQ(b / 2.0, Coord3(5.0, -10.0, 0.25));
}

TEST(Coord3, InnerAndCrossProduct) {
  EXPECT_EQ(dot({1.0, 2.0, 3.0}, {4.0, -5.0, 6.0}), 12.0);
  EXPECT_EQ(cross({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}), Coord3(0.0, 0.0, 1.0));
  EXPECT_EQ(cross({0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}), Coord3(1.0, 0.0, 0.0));
}

RC_GTEST_PROP(Coord3, CrossProductIsNormalToBothFactors, ()) {
  const Coord3 a = random::vector(10.0);
  const Coord3 b = random::vector(10.0);
  const Coord3 n = cross(a, b);
  RC_ASSERT(std::abs(dot(n, a)) < 1e-11);
  RC_ASSERT(std::abs(dot(n, b)) < 1e-11);
  RC_ASSERT(n == -cross(b, a));
  // Lagrange: |a x b|^2 + (a.b)^2 = |a|^2 |b|^2
  RC_ASSERT(std::abs(dot(n, n) + dot(a, b) * dot(a, b) - dot(a, a) * dot(b, b)) < 1e-9);
}

TEST(Coord3, NormNeitherOverflowsNorUnderflows) {
  EXPECT_DOUBLE_EQ(norm({2.0, 3.0, 6.0}), 7.0);
  EXPECT_DOUBLE_EQ(norm({2e300, 3e300, 6e300}), 7e300);
  EXPECT_DOUBLE_EQ(norm({2e-300, 3e-300, 6e-300}), 7e-300);
  EXPECT_EQ(norm({}), 0.0);
  EXPECT_EQ(norm({-kInfinity, 1.0, 0.0}), kInfinity);
}

TEST(Coord3, NormalizedHasUnitLengthAtEverySize) {
  for (const double size : {1e-320, 1e-300, 1e-3, 1.0, 1e9, 1e308}) {
    const Coord3 u = normalized(Coord3{size, -size, size});
    EXPECT_NEAR(norm(u), 1.0, 1e-15) << size;
    EXPECT_NEAR(u.x, -u.y, 1e-15) << size;
    EXPECT_GT(u.x, 0.0) << size;
  }
}

TEST(Coord3, DirectionOfNothingIsRefused) {
  EXPECT_THROW(normalized(Coord3{}), std::domain_error);
  EXPECT_THROW(normalized(Coord3{kNan, 1.0, 0.0}), std::domain_error);
  EXPECT_THROW(normalized(Coord3{1.0, 0.0, -kInfinity}), std::domain_error);
  EXPECT_THROW(Coord3(1.0, 2.0, 3.0) / 0.0, std::domain_error);
}

TEST(Coord3, FiniteMeansEveryCoordinate) {
  EXPECT_TRUE(isFinite({1.0, -2.0, 1e308}));
  EXPECT_FALSE(isFinite({kNan, 0.0, 0.0}));
  EXPECT_FALSE(isFinite({0.0, kInfinity, 0.0}));
  EXPECT_FALSE(isFinite({0.0, 0.0, -kInfinity}));
}

}  // namespace
}  // namespace coherency
