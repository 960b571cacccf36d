#include "render_client/compile/CompiledScene.h"

#include <algorithm>
#include <stdexcept>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "render_client/compile/Refine.h"

namespace coherency {
namespace {

Coord3 halfExtent(const Mesh& mesh) {
  glm::dvec3 extent(0.0);
  for (const MeshVertex& v : mesh.vertices)
    extent = glm::max(extent, glm::abs(glm::dvec3(v.position[0], v.position[1], v.position[2])));
  return Coord3(extent);
}

/// Lamps light a room, and their light varies over half a metre there; what is larger than a room is scenery,
/// which they do not reach.
double lightingEdge(const VRObject& object, const Coord3& half_extent) {
  constexpr double kEdge = 0.4;
  constexpr double kRoom = 12.0;
  const double scale = std::max(object.globalTransform().maxScale(), 1e-9);
  const double size = 2.0 * std::max({half_extent.x, half_extent.y, half_extent.z});
  const bool lit = object.faces()->material.emission < 1.0 && size * scale < kRoom;
  return lit ? std::max(kEdge / scale, size / 32.0) : 4.0 * size;
}

}  // namespace

CompiledScene::CompiledScene(const VRObject& root) {
  // Nodes are appended while the list is walked: breadth first, parents before their members.
  nodes_.push_back({&root, kNoParent});
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    const VRObject& object = *nodes_[n].object;
    addDrawable(object, n);
    for (const VRObject* member : object.members()) nodes_.push_back({member, n});
  }
  t_world_.resize(nodes_.size());
  update();
}

void CompiledScene::addDrawable(const VRObject& object, std::uint32_t node) {
  if (object.faces() == nullptr) return;
  Mesh mesh;
  try {
    mesh = buildMesh(*object.faces());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(object.path() + ": " + error.what());
  }
  if (mesh.indices.empty()) return;
  const Coord3 half_extent = halfExtent(mesh);
  const std::vector<std::uint32_t> plain = mesh.indices;
  refine(mesh, lightingEdge(object, half_extent));
  const auto size = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
  const std::uint32_t first_plain = size(indices_);
  if (mesh.indices.size() != plain.size()) indices_.insert(indices_.end(), plain.begin(), plain.end());
  drawables_.push_back({object.faces(), node, mesh.origin, half_extent, size(indices_), size(mesh.indices),
                        first_plain, size(plain), size(vertices_)});
  vertices_.insert(vertices_.end(), mesh.vertices.begin(), mesh.vertices.end());
  indices_.insert(indices_.end(), mesh.indices.begin(), mesh.indices.end());
}

void CompiledScene::update() {
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const TransformMatrix& t_parent_object = nodes_[n].object->transform();
    t_world_[n] =
        nodes_[n].parent == kNoParent ? t_parent_object : t_world_[nodes_[n].parent] * t_parent_object;
  }
}

}  // namespace coherency
