#include "common/world/Touch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "common/scene/FaceSet.h"
#include "common/scene/Senses.h"

namespace coherency {

namespace {

/// Nearest point of the segment from a to b.
Coord3 nearestOnEdge(const Coord3& p, const Coord3& a, const Coord3& b) {
  const Coord3 edge = b - a;
  return a + edge * std::clamp(dot(p - a, edge) / dot(edge, edge), 0.0, 1.0);
}

struct Near {
  double distance;
  bool behind;
  Coord3 normal;
};

/// A plane, convex face and a point; nullopt for one that is behind it, but not straight behind.
std::optional<Near> nearFace(const Coord3& p, const std::vector<Coord3>& corners) {
  Coord3 sum;
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  const Coord3 normal = normalized(sum);
  const double height = dot(p - corners[0], normal);
  const bool behind = height < 0.0;
  bool within = true;
  double nearest = std::abs(height);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Coord3& a = corners[i];
    const Coord3& b = corners[(i + 1) % corners.size()];
    if (dot(cross(b - a, p - a), normal) >= 0.0) continue;
    const double distance = norm(p - nearestOnEdge(p, a, b));
    nearest = within ? distance : std::min(nearest, distance);
    within = false;
  }
  if (behind && !within) return std::nullopt;
  return Near{nearest, behind, normal};
}

const Surface* surfaceOf(const VRObject& object) {
  for (const VRObject* o = &object; o != nullptr; o = o->parent())
    if (const auto* surface = o->attribute<Surface>(); surface != nullptr) return surface;
  return nullptr;
}

std::optional<Touched> touched(const Sphere& probe, const VRObject& object,
                               const TransformMatrix& t_world_object) {
  std::optional<Near> nearest;
  std::vector<Coord3> corners;
  for (const auto& face : object.faces()->faces) {
    corners.clear();
    for (const std::uint32_t v : face) corners.push_back(t_world_object.point(object.faces()->vertices[v]));
    const auto near = nearFace(probe.centre, corners);
    if (near && near->distance < probe.radius && (!nearest || near->distance < nearest->distance))
      nearest = near;
  }
  if (!nearest) return std::nullopt;
  Touched t;
  t.object = object.path();
  t.depth_m = probe.radius + (nearest->behind ? nearest->distance : -nearest->distance);
  t.normal = nearest->normal;
  if (const Surface* surface = surfaceOf(object); surface != nullptr) {
    t.material = surface->material;
    t.force_n = surface->stiffness_n_m * t.depth_m;
  }
  return t;
}

void visit(const Sphere& probe, const VRObject& object, const TransformMatrix& t_world_object,
           const std::vector<const VRObject*>& without, std::vector<Touched>& all) {
  if (std::find(without.begin(), without.end(), &object) != without.end()) return;
  if (object.faces() != nullptr)
    if (auto t = touched(probe, object, t_world_object)) all.push_back(std::move(*t));
  for (const VRObject* member : object.members())
    visit(probe, *member, t_world_object * member->transform(), without, all);
}

}  // namespace

std::vector<Touched> touchedBy(const Sphere& probe, const VRObject& root,
                               const std::vector<const VRObject*>& without) {
  std::vector<Touched> all;
  visit(probe, root, root.globalTransform(), without, all);
  std::stable_sort(all.begin(), all.end(),
                   [](const Touched& a, const Touched& b) { return a.depth_m > b.depth_m; });
  return all;
}

std::string describe(const std::vector<Touched>& touched) {
  if (touched.empty()) return "nothing";
  const Touched& t = touched.front();
  std::array<char, 96> how{};
  std::snprintf(how.data(), how.size(), ", %.0f mm deep", t.depth_m * 1000.0);
  std::string text = t.object.substr(t.object.rfind('/') + 1) +
                     (t.material.empty() ? "" : " (" + t.material + ")") + how.data();
  if (t.force_n > 0.0) {
    std::snprintf(how.data(), how.size(), ", pushes back with %.0f N", t.force_n);
    text += how.data();
  }
  return text;
}

}  // namespace coherency
