#include "common/world/Plan.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

double cross(PlanPoint a, PlanPoint b) {
  return a.x * b.z - a.z * b.x;
}

/// The part of a polygon on the side of a line towards which `inward` points; `inward` is dot(p, inward) <=
/// reach.
std::vector<PlanPoint> clipped(const std::vector<PlanPoint>& polygon, PlanPoint outward, double reach) {
  std::vector<PlanPoint> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanPoint a = polygon[i];
    const PlanPoint b = polygon[(i + 1) % polygon.size()];
    const double beyond_a = dot(a, outward) - reach;
    const double beyond_b = dot(b, outward) - reach;
    if (beyond_a <= 0.0) kept.push_back(a);
    if ((beyond_a < 0.0 && beyond_b > 0.0) || (beyond_a > 0.0 && beyond_b < 0.0))
      kept.push_back(a + (b - a) * (beyond_a / (beyond_a - beyond_b)));
  }
  return kept;
}

std::vector<PlanPoint> corners(const PlanRectangle& r) {
  const PlanPoint x = r.axis_x * r.half_x;
  const PlanPoint z = r.axis_z * r.half_z;
  return {r.centre - x - z, r.centre + x - z, r.centre + x + z, r.centre - x + z};
}

/// Half the extent of a rectangle along a unit vector.
double reachAlong(const PlanRectangle& r, PlanPoint axis) {
  return std::abs(dot(r.axis_x, axis)) * r.half_x + std::abs(dot(r.axis_z, axis)) * r.half_z;
}

}  // namespace

double length(PlanPoint a) {
  return std::sqrt(a.x * a.x + a.z * a.z);
}

PlanPoint between(const BasePose& from, const BasePose& to) {
  return {metresFromNanometres(to.x_nm - from.x_nm), metresFromNanometres(to.z_nm - from.z_nm)};
}

PlanRectangle rectangle(const SolidBox& box, const BasePose& origin) {
  return {
      between(origin, box.centre), {box.cosine, -box.sine}, {box.sine, box.cosine}, box.half_x, box.half_z};
}

PlanContact discInRectangle(double radius, const PlanRectangle& r) {
  const PlanPoint here = PlanPoint{} - r.centre;
  const double x = dot(here, r.axis_x);
  const double z = dot(here, r.axis_z);
  const double out_x = std::abs(x) - r.half_x;
  const double out_z = std::abs(z) - r.half_z;
  if (out_x >= radius || out_z >= radius) return {};
  const PlanPoint side_x = r.axis_x * (x < 0.0 ? -1.0 : 1.0);
  const PlanPoint side_z = r.axis_z * (z < 0.0 ? -1.0 : 1.0);
  if (out_x <= 0.0 || out_z <= 0.0) {  // over the rectangle or beside one of its sides
    const bool along_x = out_x > out_z;
    return {along_x ? side_x : side_z, radius - (along_x ? out_x : out_z)};
  }
  const PlanPoint corner{out_x, out_z};
  const double distance = length(corner);
  if (distance >= radius) return {};
  return {side_x * (out_x / distance) + side_z * (out_z / distance), radius - distance};
}

PlanContact discInDisc(double radius, PlanPoint centre, double other_radius) {
  const double distance = length(centre);
  const double depth = radius + other_radius - distance;
  if (depth <= 0.0) return {};
  return {distance > 0.0 ? centre * (-1.0 / distance) : PlanPoint{1.0, 0.0}, depth};
}

PlanContact rectangleInRectangle(const PlanRectangle& a, const PlanRectangle& b) {
  const PlanPoint apart = a.centre - b.centre;
  PlanContact least;
  bool first = true;
  for (const PlanPoint axis : {b.axis_x, b.axis_z, a.axis_x, a.axis_z}) {
    const double distance = dot(apart, axis);
    const double depth = reachAlong(a, axis) + reachAlong(b, axis) - std::abs(distance);
    if (depth <= 0.0) return {};
    if (first || depth < least.depth) least = {axis * (distance < 0.0 ? -1.0 : 1.0), depth};
    first = false;
  }
  return least;
}

std::vector<PlanPoint> common(const PlanRectangle& a, const PlanRectangle& b) {
  std::vector<PlanPoint> polygon = corners(a);
  for (const double sign : {1.0, -1.0}) {
    polygon = clipped(polygon, b.axis_x * sign, sign * dot(b.centre, b.axis_x) + b.half_x);
    polygon = clipped(polygon, b.axis_z * sign, sign * dot(b.centre, b.axis_z) + b.half_z);
  }
  return polygon;
}

/// Andrew's monotone chain (Information Processing Letters 9, 1979).
std::vector<PlanPoint> hull(std::vector<PlanPoint> points) {
  const auto before = [](PlanPoint a, PlanPoint b) { return a.x < b.x || (a.x == b.x && a.z < b.z); };
  std::stable_sort(points.begin(), points.end(), before);
  std::vector<PlanPoint> chain;
  const auto extend = [&chain](PlanPoint p, std::size_t least) {
    while (chain.size() > least && cross(chain.back() - chain[chain.size() - 2], p - chain.back()) <= 0.0)
      chain.pop_back();
    chain.push_back(p);
  };
  if (points.size() < 3) return points;
  for (const PlanPoint p : points) extend(p, 1);
  const std::size_t lower = chain.size();
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) extend(*p, lower);
  chain.pop_back();
  return chain;
}

PlanPoint nearestToOrigin(const std::vector<PlanPoint>& polygon) {
  assert(!polygon.empty());
  bool within = polygon.size() > 2;
  PlanPoint nearest = polygon.front();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlanPoint a = polygon[i];
    const PlanPoint edge = polygon[(i + 1) % polygon.size()] - a;
    within = within && cross(edge, PlanPoint{} - a) >= 0.0;
    const double square = dot(edge, edge);
    const double along = square > 0.0 ? std::clamp(-dot(a, edge) / square, 0.0, 1.0) : 0.0;
    const PlanPoint candidate = a + edge * along;
    if (dot(candidate, candidate) < dot(nearest, nearest)) nearest = candidate;
  }
  return within ? PlanPoint{} : nearest;
}

}  // namespace coherency
