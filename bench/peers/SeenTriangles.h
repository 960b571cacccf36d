#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "render_client/draw/EyeView.h"

namespace coherency {

struct TriangleFilter {
  EyeView view;
  TransformMatrix t_eye_mesh;

  /// Whether some of it may be in view: it is not wholly beyond one of the view's planes. Corners as in the
  /// mesh.
  bool passes(const std::array<Coord3, 3>& corners) const;
};

/// Appends the triangles that pass, as indices.
template <class Vertex>
void appendSeen(const TriangleFilter& filter, const Vertex* vertices, std::span<const std::uint32_t> indices,
                std::vector<std::uint32_t>& seen) {
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    std::array<Coord3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const float(&p)[3] = vertices[indices[i + k]].position;
      corners[k] = {p[0], p[1], p[2]};
    }
    if (filter.passes(corners)) seen.insert(seen.end(), &indices[i], &indices[i] + 3);
  }
}

/// Numbers of objects, nearest first, so that what they hide is not shaded; `origin` tells where one is.
template <class Object>
std::vector<std::size_t> nearestFirst(const std::vector<Object>& objects, auto&& origin, const Coord3& eye) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < objects.size(); ++i) order.emplace_back(norm(origin(objects[i]) - eye), i);
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> numbers;
  for (const auto& [distance, i] : order) numbers.push_back(i);
  return numbers;
}

}  // namespace coherency
