#include "render_client/compile/FixedMesh.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render_client/compile/MeshBuilder.h"
#include "render_client/compile/NormalMatrix.h"

namespace coherency {
namespace {

/// Light varies over less than a metre in a room. What shines by itself needs none, and what is larger than
/// any hall is scenery.
double longestEdge(const FaceSet& faces, double size) {
  constexpr double kLongest = 0.5;
  constexpr double kHall = 60.0;
  if (faces.material.emission >= kShines || size > kHall) return std::numeric_limits<double>::infinity();
  return std::max(kLongest, size / 32.0);
}

/// By its box in its own axes.
bool isRod(const Mesh& mesh, const glm::dmat3& linear) {
  glm::dvec3 half(0.0);
  for (const MeshVertex& v : mesh.vertices)
    half = glm::max(half, glm::abs(glm::dvec3(v.position[0], v.position[1], v.position[2])));
  int thin = 0;
  for (int axis = 0; axis < 3; ++axis) thin += 2.0 * half[axis] * glm::length(linear[axis]) <= kRod ? 1 : 0;
  return thin >= 2;
}

/// With its vertices from `first` on, and turned the other way round where it was mirrored.
void append(const std::vector<std::uint32_t>& triangles, std::uint32_t first, Turn turn,
            std::vector<std::uint32_t>& to) {
  const bool mirrored = turn == Turn::Mirrored;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
    for (const std::size_t c : {0U, mirrored ? 2U : 1U, mirrored ? 1U : 2U})
      to.push_back(first + triangles[i + c]);
}

}  // namespace

Mesh meshOf(const VRObject& object) {
  try {
    return buildMesh(*object.faces());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(object.path() + ": " + error.what());
  }
}

Shows FixedMesh::add(const VRObject& object, const TransformMatrix& t_world_object) {
  if (object.faces() == nullptr) return Shows::NoFaces;
  const Mesh mesh = meshOf(object);
  if (mesh.indices.empty()) return Shows::NoArea;
  const Turn turn = turnOf(t_world_object);
  if (turn == Turn::Flat) return Shows::Flat;
  const glm::dmat3 linear(t_world_object.glm());
  const glm::dmat3 normals = normalMatrix(linear);
  const auto first = static_cast<std::uint32_t>(vertices.size());
  const auto number = static_cast<std::uint32_t>(objects.size());
  double size = 0.0;
  for (const MeshVertex& v : mesh.vertices) {
    const glm::dvec3 position = linear * glm::dvec3(v.position[0], v.position[1], v.position[2]);
    const glm::dvec3 normal = normals * glm::dvec3(v.normal[0], v.normal[1], v.normal[2]);
    vertices.push_back({glm::vec3(position), glm::vec3(glm::normalize(normal)), number});
    size = std::max(size, 2.0 * glm::length(position));
  }
  append(mesh.indices, first, turn, indices);
  objects.push_back({&object,
                     t_world_object.point(mesh.origin),
                     longestEdge(*object.faces(), size),
                     isRod(mesh, linear),
                     {}});
  for (const MeshLevel& level : mesh.coarser) {
    MeshLevel placed{{}, level.error * t_world_object.maxScale()};
    append(level.indices, first, turn, placed.indices);
    objects.back().coarser.push_back(std::move(placed));
  }
  return Shows::Faces;
}

}  // namespace coherency
