#include "tests/scenes/Coplanar.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/scene/FaceSet.h"

namespace coherency::scenes {

namespace {

constexpr double kApart = 0.5e-3;   // m
constexpr double kArea = 1e-4;      // m^2
constexpr double kParallel = 0.99;  // cosine; what is tilted more does not stay within kApart over kArea

struct Face {
  const VRObject* owner;
  std::vector<Coord3> corners;
  Coord3 normal;
  Coord3 low;
  Coord3 high;
};

Coord3 areaVector(const std::vector<Coord3>& corners) {
  Coord3 sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return 0.5 * sum;
}

Face faceOf(const VRObject* owner, std::vector<Coord3> corners) {
  constexpr double kFar = std::numeric_limits<double>::max();
  const Coord3 area = areaVector(corners);
  Face face{owner, std::move(corners), area / norm(area), {kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  for (const Coord3& c : face.corners) {
    face.low = {std::min(face.low.x, c.x), std::min(face.low.y, c.y), std::min(face.low.z, c.z)};
    face.high = {std::max(face.high.x, c.x), std::max(face.high.y, c.y), std::max(face.high.z, c.z)};
  }
  return face;
}

/// Ordered by where they begin along x.
std::vector<Face> facesBelow(const VRObject& root) {
  std::vector<Face> all;
  forEachObject(root, {}, [&](const VRObject& object, const TransformMatrix& t_root_object) {
    if (object.faces() == nullptr) return;
    for (const auto& indices : object.faces()->faces) {
      std::vector<Coord3> corners;
      corners.reserve(indices.size());
      for (const std::uint32_t i : indices)
        corners.push_back(t_root_object.point(object.faces()->vertices[i]));
      all.push_back(faceOf(&object, std::move(corners)));
    }
  });
  std::sort(all.begin(), all.end(), [](const Face& a, const Face& b) { return a.low.x < b.low.x; });
  return all;
}

bool boxesMeet(const Face& a, const Face& b) {
  return a.low.y <= b.high.y + kApart && b.low.y <= a.high.y + kApart && a.low.z <= b.high.z + kApart &&
         b.low.z <= a.high.z + kApart;
}

/// The part of a polygon on the inner side of the upright plane through an edge.
std::vector<Coord3> clipped(const std::vector<Coord3>& polygon, const Coord3& from, const Coord3& inwards) {
  std::vector<Coord3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Coord3& here = polygon[i];
    const Coord3& next = polygon[(i + 1) % polygon.size()];
    const double a = dot(here - from, inwards);
    const double b = dot(next - from, inwards);
    if (a >= 0.0) kept.push_back(here);
    if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)) kept.push_back(here + (a / (a - b)) * (next - here));
  }
  return kept;
}

/// The piece of `b` that lies over `a`, as `a` is seen.
std::vector<Coord3> common(const Face& a, const Face& b) {
  std::vector<Coord3> piece = b.corners;
  for (std::size_t i = 0; i < a.corners.size() && piece.size() >= 3; ++i) {
    const Coord3& from = a.corners[i];
    piece = clipped(piece, from, cross(a.normal, a.corners[(i + 1) % a.corners.size()] - from));
  }
  return piece;
}

}  // namespace

std::vector<Fight> coplanarFaces(const VRObject& root) {
  const std::vector<Face> faces = facesBelow(root);
  std::vector<Fight> fights;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Face& a = faces[i];
    for (std::size_t k = i + 1; k < faces.size() && faces[k].low.x <= a.high.x + kApart; ++k) {
      const Face& b = faces[k];
      if (a.owner == b.owner || !boxesMeet(a, b) || dot(a.normal, b.normal) < kParallel) continue;
      const std::vector<Coord3> piece = common(a, b);
      if (piece.size() < 3) continue;
      const double area = norm(areaVector(piece));
      const bool touching = std::all_of(piece.begin(), piece.end(), [&](const Coord3& p) {
        return std::abs(dot(p - a.corners[0], a.normal)) < kApart;
      });
      if (area > kArea && touching) fights.push_back({a.owner->path(), b.owner->path(), area, piece[0]});
    }
  }
  return fights;
}

}  // namespace coherency::scenes
