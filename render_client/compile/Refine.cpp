#include "render_client/compile/Refine.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "render_client/compile/Subdivision.h"

namespace coherency {
namespace {

glm::dvec3 vec3(const float (&v)[3]) {
  return {v[0], v[1], v[2]};
}

void refine(std::vector<MeshVertex>& vertices, std::vector<std::uint32_t>& indices, double longest_edge) {
  std::vector<glm::dvec3> positions;
  double extent = 0.0;
  for (const MeshVertex& v : vertices) {
    positions.push_back(vec3(v.position));
    extent = std::max(extent, glm::length(positions.back()));
  }
  if (positions.empty()) return;
  Subdivision subdivision(positions, indices, std::max(1e-6 * extent, 1e-300));
  const auto middle = [&](std::uint32_t side) {
    const auto [a, b] = std::pair(subdivision.sides()[side].a, subdivision.sides()[side].b);
    vertices.push_back(middleOf(vertices[a], vertices[b]));
    return static_cast<std::uint32_t>(vertices.size() - 1);
  };
  bool any = true;
  for (std::size_t e = 0; any;) {
    any = false;
    for (; e < subdivision.edges().size(); ++e)
      if (subdivision.edges()[e].square > longest_edge * longest_edge) {
        subdivision.mark(e);
        any = true;
      }
    if (any) subdivision.cut(middle);
  }
  indices = subdivision.indices();
}

}  // namespace

MeshVertex middleOf(const MeshVertex& a, const MeshVertex& b) {
  MeshVertex middle = a;
  float length = 0.0F;
  for (int i = 0; i < 3; ++i) {
    middle.position[i] = 0.5F * (a.position[i] + b.position[i]);
    middle.normal[i] = a.normal[i] + b.normal[i];
    length += middle.normal[i] * middle.normal[i];
  }
  for (float& component : middle.normal) component /= std::max(std::sqrt(length), 1e-20F);
  return middle;
}

void refine(Mesh& mesh, double longest_edge) {
  assert(longest_edge > 0.0);
  refine(mesh.vertices, mesh.indices, longest_edge);
  for (MeshLevel& level : mesh.coarser) refine(mesh.vertices, level.indices, longest_edge);
}

}  // namespace coherency
