#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <rapidcheck/gtest.h>

#include "common/scene/FaceSet.h"
#include "tests/math/Random.h"

// What is looked at in the primitives' shapes.

namespace coherency {

/// Twice the area of a face, along its outward normal.
inline Coord3 areaVector(const FaceSet& set, const std::vector<std::uint32_t>& face) {
  Coord3 area;
  for (std::size_t i = 1; i + 1 < face.size(); ++i)
    area += cross(set.vertices[face[i]] - set.vertices[face[0]],
                  set.vertices[face[i + 1]] - set.vertices[face[0]]);
  return area;
}

inline Coord3 centreOf(const FaceSet& set, const std::vector<std::uint32_t>& face) {
  Coord3 sum;
  for (const std::uint32_t index : face) sum += set.vertices[index];
  return sum / static_cast<double>(face.size());
}

/// Volume by the divergence theorem; right only if the faces close and all face outward.
inline double volume(const FaceSet& set) {
  double six_volumes = 0.0;
  for (const auto& face : set.faces) six_volumes += dot(areaVector(set, face), set.vertices[face[0]]);
  return six_volumes / 6.0;
}

/// Each edge belongs to two faces that run along it in opposite directions, and no vertex is left over.
inline bool isClosed(const FaceSet& set) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::vector<bool> used(set.vertices.size(), false);
  for (const auto& face : set.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      ++edges[{face[i], face[(i + 1) % face.size()]}];
      used[face[i]] = true;
    }
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) return false;
  }
  return std::all_of(used.begin(), used.end(), [](bool u) { return u; });
}

/// Of a convex shape about the origin.
inline bool facesOutward(const FaceSet& set) {
  return std::all_of(set.faces.begin(), set.faces.end(),
                     [&](const auto& face) { return dot(areaVector(set, face), centreOf(set, face)) > 0.0; });
}

inline double anyLength() {
  return std::abs(random::magnitude(-3.0, 3.0));
}
inline int anySides() {
  return *rc::gen::inRange(3, 65);
}

}  // namespace coherency
