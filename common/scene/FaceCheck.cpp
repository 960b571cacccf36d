#include "common/scene/FaceCheck.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace coherency {
namespace {

constexpr double kFlatness = 1e-6;     // of the face's extent, as documented
constexpr double kCoincident = 1e-12;  // of the face's extent

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
  throw std::invalid_argument(what + ": " + why);
}

/// The corners about their centre, in units of their largest distance from it: every limit is then relative.
std::vector<Coord3> relativeToExtent(const std::vector<Coord3>& corners, const std::string& what) {
  Coord3 centre;
  for (const Coord3& p : corners) centre += p / static_cast<double>(corners.size());
  double extent = 0.0;
  for (const Coord3& p : corners) extent = std::max(extent, norm(p - centre));
  if (!(extent > 0.0) || !std::isfinite(extent)) refuse(what, "all vertices coincide or lie too far apart");
  std::vector<Coord3> relative;
  relative.reserve(corners.size());
  for (const Coord3& p : corners) relative.push_back((p - centre) / extent);
  return relative;
}

/// Newell's normal: twice the area, towards the side from which the corners run counter-clockwise.
Coord3 newellNormal(const std::vector<Coord3>& corners) {
  Coord3 normal;
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += cross(corners[i], corners[(i + 1) % corners.size()]);
  return normal;
}

/// Convex and wound once: no corner lies to the right of any edge.
bool isConvex(const std::vector<Coord3>& corners, const Coord3& normal) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Coord3 inward = cross(normal, normalized(corners[(i + 1) % corners.size()] - corners[i]));
    for (const Coord3& p : corners)
      if (dot(inward, p - corners[i]) < -kFlatness) return false;
  }
  return true;
}

}  // namespace

void checkFace(const std::vector<Coord3>& corners, const std::string& what) {
  if (corners.size() < 3)
    refuse(what, "has " + std::to_string(corners.size()) + " vertices; a polygon has at least 3");
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (!isFinite(corners[i])) refuse(what, "vertex " + std::to_string(i) + " is not finite");

  const std::vector<Coord3> relative = relativeToExtent(corners, what);
  for (std::size_t i = 0; i < relative.size(); ++i) {
    const std::size_t next = (i + 1) % relative.size();
    if (norm(relative[next] - relative[i]) < kCoincident)
      refuse(what, "vertices " + std::to_string(i) + " and " + std::to_string(next) + " coincide");
  }
  const Coord3 area = newellNormal(relative);
  if (norm(area) < kCoincident) refuse(what, "is degenerate: its vertices enclose no area");
  const Coord3 normal = normalized(area);
  for (std::size_t i = 0; i < relative.size(); ++i)
    if (std::abs(dot(normal, relative[i])) > kFlatness)
      refuse(what, "vertex " + std::to_string(i) + " lies out of the plane of the others");
  if (!isConvex(relative, normal)) refuse(what, "is not convex");
}

}  // namespace coherency
