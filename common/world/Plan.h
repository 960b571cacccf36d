#pragma once

#include <vector>

#include "common/world/WorldModel.h"

// Plane geometry seen from above: points are (x, z) in metres. Only additions, multiplications, divisions and
// square roots, so that what replicated state takes from it is the same bits everywhere.

namespace coherency {

struct PlanPoint {
  double x = 0.0;
  double z = 0.0;
};
inline PlanPoint operator+(PlanPoint a, PlanPoint b) {
  return {a.x + b.x, a.z + b.z};
}
inline PlanPoint operator-(PlanPoint a, PlanPoint b) {
  return {a.x - b.x, a.z - b.z};
}
inline PlanPoint operator*(PlanPoint a, double s) {
  return {a.x * s, a.z * s};
}
inline double dot(PlanPoint a, PlanPoint b) {
  return a.x * b.x + a.z * b.z;
}
double length(PlanPoint a);

/// Exact where the two are near each other, however far both are from the origin.
PlanPoint between(const BasePose& from, const BasePose& to);

/// A rectangle: the axes are unit vectors at right angles.
struct PlanRectangle {
  PlanPoint centre;
  PlanPoint axis_x;
  PlanPoint axis_z;
  double half_x = 0.0;
  double half_z = 0.0;
};
/// `box` as seen from `origin`.
PlanRectangle rectangle(const SolidBox& box, const BasePose& origin);

/// How a shape must move to leave another: by `depth` along the unit vector `away`; depth 0: it is clear of
/// it.
struct PlanContact {
  PlanPoint away;
  double depth = 0.0;
};
/// For a disc about the origin.
PlanContact discInRectangle(double radius, const PlanRectangle& rectangle);
/// For a disc about the origin, from another about `centre`.
PlanContact discInDisc(double radius, PlanPoint centre, double other_radius);
/// For rectangle `a`, by the shortest way (separating axes).
PlanContact rectangleInRectangle(const PlanRectangle& a, const PlanRectangle& b);

/// The convex polygon two rectangles have in common; empty where there is none.
std::vector<PlanPoint> common(const PlanRectangle& a, const PlanRectangle& b);
/// Convex hull, counter-clockwise seen with z to the right of x; what it was given may lie on it twice.
std::vector<PlanPoint> hull(std::vector<PlanPoint> points);
/// The point of a convex polygon nearest to the origin; the origin itself where it lies within. Precondition:
/// not empty.
PlanPoint nearestToOrigin(const std::vector<PlanPoint>& polygon);

}  // namespace coherency
