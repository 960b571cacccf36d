#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/TransformMatrix.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Any 3x3 part: shear, mirroring and singular ones too, elements of very different size.
TransformMatrix anyLinear() {
  TransformMatrix m;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      m(row, column) = *rc::gen::inRange(0, 4) == 0 ? 0.0 : random::magnitude(-8.0, 4.0);
  return m;
}

/// The direction that grows most, by power iteration on transpose(m) * m.
Coord3 mostStretched(const TransformMatrix& m, Coord3 v) {
  TransformMatrix transposed;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) transposed(row, column) = m(column, row);
  for (int step = 0; step < 300; ++step) {
    const Coord3 next = transposed.vector(m.vector(v));
    if (norm(next) == 0.0) break;
    v = normalized(next);
  }
  return v;
}

RC_GTEST_PROP(MaxScale, NoVectorGrowsByMore, ()) {
  const TransformMatrix m = anyLinear();
  const Coord3 v = random::vector(1.0);
  RC_ASSERT(norm(m.vector(v)) <= m.maxScale() * norm(v));
}

RC_GTEST_PROP(MaxScale, NotEvenTheDirectionThatGrowsMost, ()) {
  const TransformMatrix m = anyLinear();
  const Coord3 v = mostStretched(m, random::direction());
  RC_ASSERT(norm(v) <= 1.0 + 1e-15);
  RC_ASSERT(norm(m.vector(v)) <= m.maxScale() * norm(v));
}

/// Rotations on both sides leave the singular values as they were put in.
RC_GTEST_PROP(MaxScale, IsTight, ()) {
  const Coord3 s{random::magnitude(-6, 6), random::magnitude(-6, 6), random::magnitude(-6, 6)};
  const TransformMatrix m = random::rotationMatrix() * TransformMatrix::scaling(s) * random::rotationMatrix();
  const double exact = std::max({std::abs(s.x), std::abs(s.y), std::abs(s.z)});
  RC_ASSERT(std::abs(m.maxScale() / exact - 1.0) < 1e-11);
}

RC_GTEST_PROP(MaxScale, RoundsOutward, ()) {
  const double s = std::abs(random::magnitude(-300.0, 300.0));
  RC_ASSERT(TransformMatrix::scaling({s, -s, s}).maxScale() > s);
  RC_ASSERT(random::rigid(1e6).maxScale() >= 1.0);
  RC_ASSERT(random::rigid(1e6).maxScale() < 1.0 + 1e-11);
}

TEST(MaxScale, CountsShear) {
  TransformMatrix shear;
  shear(0, 1) = 1.0;  // golden ratio: singular values of [[1, 1], [0, 1]]
  EXPECT_NEAR(shear.maxScale(), (1.0 + std::sqrt(5.0)) / 2.0, 1e-11);
  EXPECT_GE(shear.maxScale(), (1.0 + std::sqrt(5.0)) / 2.0);
}

TEST(MaxScale, IgnoresTranslation) {
  EXPECT_LT(TransformMatrix::translation({1e9, 0.0, 0.0}).maxScale(), 1.0 + 1e-11);
}

TEST(MaxScale, HoldsAtTheExtremes) {
  EXPECT_EQ(TransformMatrix::scaling({0.0, 0.0, 0.0}).maxScale(), 0.0);
  EXPECT_NEAR(TransformMatrix::scaling({1e300, 1e-300, 0.0}).maxScale() / 1e300, 1.0, 1e-11);
  EXPECT_GE(TransformMatrix::scaling({5e-324, 0.0, 0.0}).maxScale(), 5e-324);
  EXPECT_EQ(TransformMatrix::scaling({std::nan(""), 1.0, 1.0}).maxScale(), kInfinity);
  EXPECT_EQ(TransformMatrix::scaling({1.0, -kInfinity, 1.0}).maxScale(), kInfinity);
}

}  // namespace
}  // namespace coherency
