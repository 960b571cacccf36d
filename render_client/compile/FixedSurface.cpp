#include "render_client/compile/FixedSurface.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace coherency {
namespace {

constexpr double kWeld = 1.0 / 8192.0;  ///< m

/// Middle of the box about all that keeps light away.
Coord3 middleOf(const FixedMesh& mesh) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  glm::dvec3 low(kFar);
  glm::dvec3 high(-kFar);
  for (const FixedVertex& v : mesh.vertices) {
    const FixedObject& object = mesh.objects[v.object];
    if (object.object->faces()->material.emission >= kShines) continue;
    const glm::dvec3 at = object.origin.glm() + glm::dvec3(v.position);
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  return low.x <= high.x ? Coord3(0.5 * (low + high)) : Coord3{};
}

}  // namespace

FixedSurface::FixedSurface(FixedMesh& mesh)
    : mesh_(mesh), origin_(coherency::middleOf(mesh)), subdivision_(positions(), mesh.indices, kWeld) {
  findInsides();
}

glm::dvec3 FixedSurface::fromOrigin(const FixedVertex& vertex) const {
  return (mesh_.objects[vertex.object].origin - origin_).glm() + glm::dvec3(vertex.position);
}

std::vector<glm::dvec3> FixedSurface::positions() const {
  std::vector<glm::dvec3> all;
  all.reserve(mesh_.vertices.size());
  for (const FixedVertex& v : mesh_.vertices) all.push_back(fromOrigin(v));
  return all;
}

/// Towards the middle of the triangles about a vertex: next to nothing, but at a border.
void FixedSurface::findInsides() {
  inside_.assign(mesh_.vertices.size(), glm::vec3(0.0F));
  std::vector<float> counts(mesh_.vertices.size(), 0.0F);
  for (std::size_t i = 0; i < mesh_.indices.size(); ++i) {
    const std::size_t first = i - i % 3;
    const std::uint32_t v = mesh_.indices[i];
    for (std::size_t c = first; c < first + 3; ++c)
      inside_[v] += (mesh_.vertices[mesh_.indices[c]].position - mesh_.vertices[v].position) / 3.0F;
    ++counts[v];
  }
  for (std::size_t v = 0; v < inside_.size(); ++v) inside_[v] /= std::max(counts[v], 1.0F);
}

FixedVertex FixedSurface::middleOf(const Subdivision::Side& side) const {
  const FixedVertex& a = mesh_.vertices[side.a];
  const FixedVertex& b = mesh_.vertices[side.b];
  const glm::vec3 normal = a.normal + b.normal;
  return {0.5F * (a.position + b.position), normal / std::max(glm::length(normal), 1e-20F), a.object};
}

glm::vec3 FixedSurface::insideOf(const Subdivision::Side& side) const {
  if (!side.border) return glm::vec3(0.0F);
  const auto position = [&](std::uint32_t v) { return mesh_.vertices[v].position; };
  return (position(side.opposite) - 0.5F * (position(side.a) + position(side.b))) / 3.0F;
}

void FixedSurface::addMiddle(const Subdivision::Side& side) {
  mesh_.vertices.push_back(middleOf(side));
  inside_.push_back(insideOf(side));
}

bool FixedSurface::markLongEdges() {
  bool any = false;
  for (; next_ < subdivision_.edges().size(); ++next_) {
    const Subdivision::Edge& edge = subdivision_.edges()[next_];
    double longest = std::numeric_limits<double>::infinity();
    for (std::uint32_t s = edge.side; s != Subdivision::kNone; s = subdivision_.sides()[s].next)
      longest = std::min(longest, mesh_.objectOf(subdivision_.sides()[s].a).longest_edge);
    if (edge.square <= longest * longest) continue;
    mark(next_);
    any = true;
  }
  return any;
}

void FixedSurface::cutLongEdges() {
  while (markLongEdges()) cut([](std::uint32_t) {});
}

SurfacePoint FixedSurface::at(std::uint32_t vertex) const {
  const FixedVertex& v = mesh_.vertices[vertex];
  return {glm::vec3(fromOrigin(v)), v.normal, inside_[vertex]};
}

SurfacePoint FixedSurface::halfway(const Subdivision::Side& side) const {
  const FixedVertex middle = middleOf(side);
  return {glm::vec3(fromOrigin(middle)), middle.normal, insideOf(side)};
}

std::vector<Occluder> FixedSurface::occluders() const {
  std::vector<Occluder> all;
  for (std::size_t i = 0; i + 2 < mesh_.indices.size(); i += 3) {
    const FixedObject& object = mesh_.objectOf(mesh_.indices[i]);
    const Material& material = object.object->faces()->material;
    if (material.emission >= kShines || object.rod) continue;
    Occluder occluder{{}, glm::vec3(material.colour.glm())};
    for (std::size_t c = 0; c < 3; ++c)
      occluder.corners[c] = glm::vec3(fromOrigin(mesh_.vertices[mesh_.indices[i + c]]));
    all.push_back(occluder);
  }
  return all;
}

}  // namespace coherency
