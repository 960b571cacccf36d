// Coarser levels of curved primitives: closed, over the vertices that are there, and no farther off than they
// say.

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "common/math/FixedPoint.h"
#include "common/scene/Primitives.h"
#include "tests/scene/Shapes.h"
#include "tests/scene/Support.h"

namespace coherency {
namespace {

constexpr double kRounding = 1e-9;  // of a shape's size

/// A level as a shape of its own, without the vertices it does not use.
FaceSet alone(const FaceSet& set, const DetailLevel& level) {
  FaceSet shape;
  std::map<std::uint32_t, std::uint32_t> place;
  for (std::vector<std::uint32_t> face : level.faces) {
    for (std::uint32_t& v : face) {
      const auto [at, is_new] = place.try_emplace(v, static_cast<std::uint32_t>(shape.vertices.size()));
      if (is_new) shape.vertices.push_back(set.vertices.at(v));
      v = at->second;
    }
    shape.faces.push_back(std::move(face));
  }
  return shape;
}

/// Calls visit(point) all over the faces.
void forPoints(const FaceSet& shape, const auto& visit) {
  constexpr int kSteps = 8;
  for (const auto& face : shape.faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      for (int a = 0; a <= kSteps; ++a)
        for (int b = 0; a + b <= kSteps; ++b) {
          const Coord3& corner = shape.vertices[face[0]];
          visit(corner + a / static_cast<double>(kSteps) * (shape.vertices[face[i]] - corner) +
                b / static_cast<double>(kSteps) * (shape.vertices[face[i + 1]] - corner));
        }
}

/// How far the finest reaches out of a level: both are convex, so a corner of the one is the farthest.
double reachOut(const FaceSet& finest, const FaceSet& level) {
  double most = 0.0;
  for (const Coord3& v : finest.vertices)
    for (const auto& face : level.faces)
      most = std::max(most, dot(normalized(areaVector(level, face)), v - level.vertices[face[0]]));
  return most;
}

void expectLevelIsSound(const FaceSet& set, const DetailLevel& level, double size) {
  const FaceSet shape = alone(set, level);
  RC_ASSERT(isClosed(shape));
  RC_ASSERT(facesOutward(shape));
  RC_ASSERT(reachOut(set, shape) <= level.error + kRounding * size);
}

RC_GTEST_PROP(DetailLevel, OfAFrustumLiesWithinItsErrorOfTheCone, ()) {
  const double bottom = anyLength();
  const double top = *rc::gen::element(bottom, 0.0, 0.5 * bottom, 3.0 * bottom);
  const double height = anyLength();
  Cylinder cylinder;
  cylinder.setTapered(bottom, top, height, anySides());
  const FaceSet& set = *cylinder.faces();
  const double size = std::max({bottom, top, height});
  for (const DetailLevel& level : set.coarser) {
    expectLevelIsSound(set, level, size);
    double farthest = 0.0;
    forPoints(alone(set, level), [&](const Coord3& p) {
      if (std::abs(std::abs(p.y) - 0.5 * height) < kRounding * height) return;  // on a cap
      const double radius = bottom + (top - bottom) * (p.y / height + 0.5);
      farthest = std::max(farthest, radius - std::hypot(p.x, p.z));
    });
    RC_ASSERT(farthest <= level.error + kRounding * size);
    if (bottom == top) RC_ASSERT(farthest > 0.99 * level.error);
  }
}

RC_GTEST_PROP(DetailLevel, OfAnEllipsoidLiesWithinItsErrorOfIt, ()) {
  const bool is_sphere = *rc::gen::arbitrary<bool>();
  const double x = anyLength();
  const Coord3 axes = is_sphere ? Coord3{x, x, x} : Coord3{x, anyLength(), anyLength()};
  const Ellipsoid ellipsoid(axes, 2 * *rc::gen::inRange(2, 33));
  const FaceSet& set = *ellipsoid.faces();
  const double size = std::max({axes.x, axes.y, axes.z});
  for (const DetailLevel& level : set.coarser) {
    expectLevelIsSound(set, level, size);
    double farthest = 0.0;
    forPoints(alone(set, level), [&](const Coord3& p) {
      const double share = norm({p.x / axes.x, p.y / axes.y, p.z / axes.z});
      farthest = std::max(farthest, norm(p) * (1.0 / share - 1.0));
    });
    RC_ASSERT(farthest <= level.error + kRounding * size);
    if (is_sphere) RC_ASSERT(farthest > 0.5 * level.error);
  }
}

std::vector<std::size_t> polygonCounts(const Polyhedron& shape) {
  std::vector<std::size_t> counts;
  counts.reserve(shape.faces()->coarser.size());
  for (const DetailLevel& level : shape.faces()->coarser) counts.push_back(level.faces.size());
  return counts;
}

TEST(DetailLevel, HasHalfTheSidesOfTheOneBeforeSixAtLeast) {
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(polygonCounts(Cylinder(1.0, 1.0, 24)), (Counts{12 + 2, 6 + 2}));
  EXPECT_EQ(polygonCounts(Cylinder(1.0, 1.0, 18)), (Counts{9 + 2}));
  for (const int few : {3, 6, 10, 13}) EXPECT_EQ(polygonCounts(Cylinder(1.0, 1.0, few)), Counts{}) << few;
  EXPECT_EQ(polygonCounts(Ellipsoid({1.0, 2.0, 3.0}, 24)), (Counts{12 * 6, 6 * 3}));
  for (const int few : {4, 8, 10, 18})
    EXPECT_EQ(polygonCounts(Ellipsoid({1.0, 2.0, 3.0}, few)), Counts{}) << few << ": half the bands are odd";
  EXPECT_EQ(polygonCounts(Box()), Counts{});
}

TEST(DetailLevel, GoesWithTheShape) {
  Cylinder cylinder(1.0, 1.0, 24);
  cylinder.setSize(1.0, 1.0, 6);
  EXPECT_TRUE(cylinder.faces()->coarser.empty());
  cylinder.setSize(2.0, 1.0, 12);
  EXPECT_NEAR(cylinder.faces()->coarser.at(0).error, 2.0 * (1.0 - std::cos(kTurn / 12.0)), 1e-12);
}

TEST(DetailLevel, IsRefusedWhereItCannotBeDrawn) {
  const FaceSet fine = *Cylinder(1.0, 1.0, 24).faces();
  const auto set = [&](const std::vector<DetailLevel>& coarser) {
    Polyhedron("pipe").setShape(fine.vertices, fine.faces, true, coarser);
  };
  EXPECT_NO_THROW(set(fine.coarser));
  using Refused = std::invalid_argument;
  std::vector<DetailLevel> bad = fine.coarser;
  bad[1].faces[3][0] = 48;
  expectRefusal<Refused>([&] { set(bad); }, "'pipe'", "coarser level 1: face 3", "48", "out of range");
  bad = fine.coarser;
  bad[0].faces[2].pop_back();
  bad[0].faces[2].pop_back();
  expectRefusal<Refused>([&] { set(bad); }, "coarser level 0: face 2", "at least 3");
  for (const double error : {0.0, -1.0, fine.coarser[0].error, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
    bad = fine.coarser;
    bad[1].error = error;
    expectRefusal<Refused>([&] { set(bad); }, "coarser level 1", "error", "above");
  }
}

}  // namespace
}  // namespace coherency
