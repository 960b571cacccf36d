#include "render_client/compile/CompiledScene.h"

#include <stdexcept>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace coherency {
namespace {

Coord3 halfExtent(const Mesh& mesh) {
  glm::dvec3 extent(0.0);
  for (const MeshVertex& v : mesh.vertices)
    extent = glm::max(extent, glm::abs(glm::dvec3(v.position[0], v.position[1], v.position[2])));
  return Coord3(extent);
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
  drawables_.push_back(
      {object.faces(), node, mesh.origin, halfExtent(mesh), static_cast<std::uint32_t>(indices_.size()),
       static_cast<std::uint32_t>(mesh.indices.size()), static_cast<std::uint32_t>(vertices_.size())});
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
