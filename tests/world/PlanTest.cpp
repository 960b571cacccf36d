// Plane geometry against brute force.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/world/Plan.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

PlanRectangle anyRectangle(double extent) {
  const double turn = random::angle();
  return {{random::real(-extent, extent), random::real(-extent, extent)},
          {std::cos(turn), -std::sin(turn)},
          {std::sin(turn), std::cos(turn)},
          random::real(0.05, 1.0),
          random::real(0.05, 1.0)};
}

bool within(const PlanRectangle& r, PlanPoint p, double margin = 0.0) {
  const PlanPoint d = p - r.centre;
  return std::abs(dot(d, r.axis_x)) <= r.half_x + margin && std::abs(dot(d, r.axis_z)) <= r.half_z + margin;
}

double area(const std::vector<PlanPoint>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanPoint a = polygon[i];
    const PlanPoint b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.z - a.z * b.x;
  }
  return std::abs(twice) / 2;
}

RC_GTEST_PROP(Plan, ADiscThatMovesAwayAsToldTouches, ()) {
  const PlanRectangle r = anyRectangle(1.0);
  const double radius = random::real(0.1, 0.8);
  const PlanContact contact = discInRectangle(radius, r);
  RC_PRE(contact.depth > 0.0);
  RC_ASSERT(std::abs(length(contact.away) - 1.0) < 1e-12);
  const auto shifted = [&](double by) {
    PlanRectangle moved = r;  // the disc moves one way as the rectangle does the other
    moved.centre = moved.centre - contact.away * by;
    return discInRectangle(radius, moved).depth;
  };
  RC_ASSERT(shifted(contact.depth + 1e-9) == 0.0);
  RC_ASSERT(std::abs(shifted(contact.depth * 0.99) - contact.depth * 0.01) < 1e-9);
}

RC_GTEST_PROP(Plan, ADiscIsInARectangleExactlyIfAPointOfItIs, ()) {
  const PlanRectangle r = anyRectangle(1.5);
  const double radius = random::real(0.1, 0.8);
  // The rectangle's point nearest to the disc's centre.
  const PlanPoint here = PlanPoint{} - r.centre;
  const PlanPoint nearest = r.centre + r.axis_x * std::clamp(dot(here, r.axis_x), -r.half_x, r.half_x) +
                            r.axis_z * std::clamp(dot(here, r.axis_z), -r.half_z, r.half_z);
  const double gap = length(nearest) - radius;
  RC_PRE(std::abs(gap) > 1e-9);
  RC_ASSERT((discInRectangle(radius, r).depth > 0.0) == (gap < 0.0));
}

RC_GTEST_PROP(Plan, TwoDiscsPart, ()) {
  const PlanPoint centre{random::real(-1, 1), random::real(-1, 1)};
  const PlanContact contact = discInDisc(0.4, centre, 0.5);
  RC_ASSERT((contact.depth > 0.0) == (length(centre) < 0.9));
  if (contact.depth > 0.0) RC_ASSERT(std::abs(length(centre - contact.away * contact.depth) - 0.9) < 1e-12);
}

RC_GTEST_PROP(Plan, RectanglesOverlapExactlyIfTheyHaveAreaInCommon, ()) {
  const PlanRectangle a = anyRectangle(1.0);
  const PlanRectangle b = anyRectangle(1.0);
  const PlanContact contact = rectangleInRectangle(a, b);
  const double shared = area(common(a, b));
  RC_PRE(contact.depth == 0.0 || contact.depth > 1e-6);
  RC_ASSERT((contact.depth > 0.0) == (shared > 1e-13));
  if (contact.depth > 0.0) {
    PlanRectangle moved = a;
    moved.centre = moved.centre + contact.away * (contact.depth + 1e-9);
    RC_ASSERT(rectangleInRectangle(moved, b).depth == 0.0);
  }
}

RC_GTEST_PROP(Plan, CommonAreaIsWhatSamplesSay, ()) {
  const PlanRectangle a = anyRectangle(0.6);
  const PlanRectangle b = anyRectangle(0.6);
  const auto polygon = common(a, b);
  for (const PlanPoint p : polygon) {
    RC_ASSERT(within(a, p, 1e-9));
    RC_ASSERT(within(b, p, 1e-9));
  }
  constexpr int kGrid = 60;
  int both = 0;
  for (int i = 0; i < kGrid; ++i)
    for (int k = 0; k < kGrid; ++k)
      both += within(a, {(i + 0.5) / kGrid * 4 - 2, (k + 0.5) / kGrid * 4 - 2}) &&
              within(b, {(i + 0.5) / kGrid * 4 - 2, (k + 0.5) / kGrid * 4 - 2});
  RC_ASSERT(std::abs(area(polygon) - both * 16.0 / (kGrid * kGrid)) < 0.08);
}

RC_GTEST_PROP(Plan, AHullHoldsAllItsPointsAndIsConvex, ()) {
  std::vector<PlanPoint> points;
  const int count = *rc::gen::inRange(3, 20);
  for (int i = 0; i < count; ++i) points.push_back({random::real(-1, 1), random::real(-1, 1)});
  const auto around = hull(points);
  RC_PRE(around.size() > 2);
  for (std::size_t i = 0; i < around.size(); ++i) {
    const PlanPoint edge = around[(i + 1) % around.size()] - around[i];
    for (const PlanPoint p : points) {
      const PlanPoint d = p - around[i];
      RC_ASSERT(edge.x * d.z - edge.z * d.x >= -1e-12);
    }
  }
}

RC_GTEST_PROP(Plan, NearestToTheOriginIsNearest, ()) {
  const PlanRectangle r = anyRectangle(2.0);
  const auto polygon = hull(common(r, r));
  const PlanPoint nearest = nearestToOrigin(polygon);
  RC_ASSERT(within(r, nearest, 1e-9));
  RC_ASSERT(within(r, {}) == (nearest.x == 0.0 && nearest.z == 0.0));
  for (int i = 0; i < 50; ++i) {
    const PlanPoint p =
        r.centre + r.axis_x * (random::real(-1, 1) * r.half_x) + r.axis_z * (random::real(-1, 1) * r.half_z);
    RC_ASSERT(length(nearest) <= length(p) + 1e-12);
  }
}

TEST(Plan, FarFromTheOriginNothingIsLost) {
  BasePose a;
  a.x_nm = 999'999'999'123'456'789;
  BasePose b = a;
  b.x_nm += 1;
  EXPECT_EQ(between(a, b).x, 1e-9);
}

TEST(Plan, PointsAndLinesAreHullsToo) {
  EXPECT_EQ(hull({{1, 1}}).size(), 1U);
  const std::vector<PlanPoint> line = {{0, 1}, {1, 1}};
  EXPECT_NEAR(nearestToOrigin(line).z, 1.0, 1e-15);
  EXPECT_NEAR(nearestToOrigin({{2, 1}}).x, 2.0, 1e-15);
}

}  // namespace
}  // namespace coherency
