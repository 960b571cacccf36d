#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render_client/compile/FixedMesh.h"

namespace coherency {

/// A flat surface of one object that has been cut for its light.
struct Chart {
  std::vector<std::uint32_t> cut;  ///< three vertices a triangle, as cut
  glm::dvec3 u{0.0}, v{0.0};       ///< axes in its plane, unit length, world's
  glm::dvec2 low{0.0}, size{0.0};  ///< of the rectangle about it: m along them, from the object's origin
  double shortest = 0.0;           ///< of its edges as cut, m

  /// m along the axes from `low`.
  glm::dvec2 place(const FixedVertex& vertex) const;
};

struct Charts {
  static constexpr std::uint32_t kNone = UINT32_MAX;
  std::vector<Chart> charts;
  std::vector<std::uint32_t> of_vertex;  ///< the chart a vertex is in, or kNone; empty where there are none
};

/// Flat surfaces, connected by vertices, of which there are more triangles in `mesh` than before it was cut:
/// in `uncut`. Both are object by object. Curved objects have no charts. Rectangles lie along an edge the
/// surface had before, so that they are small.
Charts findCharts(const FixedMesh& mesh, const std::vector<std::uint32_t>& uncut);

}  // namespace coherency
