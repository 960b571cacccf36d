// What is in sight of what, against looking through all triangles one by one.

#include <cmath>
#include <optional>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "render_client/compile/RayScene.h"

namespace coherency {
namespace {

using Random = std::mt19937;

glm::vec3 pointIn(Random& random, float size) {
  std::uniform_real_distribution<float> coordinate(-size, size);
  const float x = coordinate(random);
  const float y = coordinate(random);
  return {x, y, coordinate(random)};
}

/// Small ones all about, large ones, and some without area.
std::vector<RayTriangle> someTriangles(Random& random, std::size_t count) {
  std::vector<RayTriangle> all;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 at = pointIn(random, 5.0F);
    const float size = i % 7 == 0 ? 4.0F : 0.4F;
    const glm::vec3 first = at + pointIn(random, size);
    all.push_back({at, first, i % 11 == 0 ? first : at + pointIn(random, size)});
  }
  return all;
}

struct Met {
  double distance;
  double inside;  ///< least barycentric coordinate: how far from an edge, as a share
};

/// In double; where the ray's line meets the triangle's plane within or near the triangle.
std::optional<Met> meet(const RayTriangle& t, const glm::vec3& from, const glm::vec3& along) {
  const glm::dvec3 a(t[0]);
  const glm::dvec3 e1 = glm::dvec3(t[1]) - a;
  const glm::dvec3 e2 = glm::dvec3(t[2]) - a;
  const glm::dvec3 d(along);
  const glm::dvec3 p = glm::cross(d, e2);
  const double det = glm::dot(e1, p);
  if (std::abs(det) < 1e-12) return std::nullopt;
  const glm::dvec3 s = glm::dvec3(from) - a;
  const glm::dvec3 q = glm::cross(s, e1);
  const double u = glm::dot(s, p) / det;
  const double v = glm::dot(d, q) / det;
  return Met{glm::dot(e2, q) / det, std::min({u, v, 1.0 - u - v})};
}

/// Distances of the nearest triangle that is met for certain, and of the nearest that may be: between them
/// the answer must lie.
struct Expected {
  double certain = 1e9;
  double possible = 1e9;
};
Expected lookThrough(const std::vector<RayTriangle>& triangles, const glm::vec3& from,
                     const glm::vec3& along) {
  constexpr double kDoubt = 1e-3;
  Expected expected;
  for (const RayTriangle& t : triangles) {
    const std::optional<Met> met = meet(t, from, along);
    if (!met || met->inside < -kDoubt || met->distance < -kDoubt) continue;
    expected.possible = std::min(expected.possible, met->distance);
    if (met->inside > kDoubt && met->distance > kDoubt)
      expected.certain = std::min(expected.certain, met->distance);
  }
  return expected;
}

RC_GTEST_PROP(RayScene, MeetsWhatLookingThroughAllTrianglesMeets, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(0, 400);
  Random random(*rc::gen::arbitrary<std::uint32_t>());
  const std::vector<RayTriangle> triangles = someTriangles(random, count);
  const RayScene scene(triangles);
  for (int i = 0; i < 40; ++i) {
    const glm::vec3 from = pointIn(random, 6.0F);
    glm::vec3 along = pointIn(random, 1.0F);
    if (i % 5 == 0) along[i % 3] = 0.0F;
    constexpr float kReach = 5.0F;
    const Expected expected = lookThrough(triangles, from, along);
    RayHit hit;
    const bool any = scene.nearest(from, along, kReach, hit);
    if (expected.certain < kReach - 0.01) RC_ASSERT(any);
    if (expected.possible > kReach + 0.01) RC_ASSERT(!any);
    if (any) {
      RC_ASSERT(hit.distance > expected.possible - 0.01);
      RC_ASSERT(hit.distance < expected.certain + 0.01);
      const std::optional<Met> met = meet(triangles.at(hit.triangle), from, along);
      RC_ASSERT(met.has_value());
      RC_ASSERT(std::abs(met->distance - hit.distance) < 0.01);
    }
    RC_ASSERT(scene.blocked(from, from + kReach * along) == any);
  }
}

/// Eight corners of a box, twelve triangles, outward.
std::vector<RayTriangle> box(const glm::vec3& half) {
  std::vector<RayTriangle> all;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0F, 1.0F}) {
      glm::vec3 n(0.0F);
      n[axis] = side;
      glm::vec3 u(0.0F);
      u[(axis + 1) % 3] = 1.0F;
      const glm::vec3 v = glm::cross(n, u);
      const auto corner = [&](float a, float b) { return (n + a * u + b * v) * half; };
      all.push_back({corner(-1, -1), corner(1, -1), corner(1, 1)});
      all.push_back({corner(-1, -1), corner(1, 1), corner(-1, 1)});
    }
  return all;
}

TEST(RayScene, NothingGetsOutOfAClosedBoxNotEvenThroughItsEdges) {
  const RayScene scene(box({1.0F, 2.0F, 0.7F}));
  Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    glm::vec3 to = pointIn(random, 3.0F);
    if (i % 2 == 0) {  // exactly at edges, corners and diagonals
      to = glm::vec3(i & 2 ? 1.0F : -1.0F, i & 4 ? 2.0F : -2.0F, i & 8 ? 0.7F : -0.7F);
      to[i % 3] *= std::uniform_real_distribution<float>(-1.0F, 1.0F)(random);
    }
    RayHit hit;
    ASSERT_TRUE(scene.nearest({0.1F, 0.2F, 0.05F}, 3.0F * to, 100.0F, hit)) << i;
    EXPECT_TRUE(hit.from_behind);
  }
}

TEST(RayScene, BothSidesStopARayAndItKnowsWhich) {
  const RayScene scene({{glm::vec3(-1, 0, -1), glm::vec3(0, 0, 2), glm::vec3(1, 0, -1)}});  // faces up
  RayHit hit;
  ASSERT_TRUE(scene.nearest({0, 2, 0}, {0, -1, 0}, 5.0F, hit));
  EXPECT_FLOAT_EQ(hit.distance, 2.0F);
  EXPECT_FALSE(hit.from_behind);
  ASSERT_TRUE(scene.nearest({0, -1, 0}, {0, 1, 0}, 5.0F, hit));
  EXPECT_TRUE(hit.from_behind);
  EXPECT_FALSE(scene.nearest({0, 2, 0}, {0, -1, 0}, 1.9F, hit)) << "out of reach";
  EXPECT_FALSE(scene.blocked({0, 2, 0}, {0, 0.1F, 0}));
}

TEST(RayScene, TakesNothingAndAThousandTimesTheSame) {
  RayHit hit;
  EXPECT_FALSE(RayScene().nearest({0, 0, 0}, {0, 1, 0}, 10.0F, hit));
  EXPECT_FALSE(RayScene().blocked({0, 0, 0}, {0, 1, 0}));
  const RayTriangle same{glm::vec3(-1, 1, -1), glm::vec3(0, 1, 2), glm::vec3(1, 1, -1)};
  EXPECT_TRUE(RayScene(std::vector<RayTriangle>(1000, same)).nearest({0, 0, 0}, {0, 1, 0}, 10.0F, hit));
  EXPECT_FLOAT_EQ(hit.distance, 1.0F);
}

TEST(RayScene, AGuessAtWhatIsInTheWayChangesNoAnswer) {
  Random random(7);
  const std::vector<RayTriangle> triangles = someTriangles(random, 200);
  const RayScene scene(triangles);
  std::int32_t blocker = RayScene::kNoBlocker;
  for (int i = 0; i < 2000; ++i) {
    const glm::vec3 from = pointIn(random, 5.0F);
    const glm::vec3 to = pointIn(random, 5.0F);
    ASSERT_EQ(scene.blocked(from, to, blocker), scene.blocked(from, to)) << i;
  }
}

}  // namespace
}  // namespace coherency
