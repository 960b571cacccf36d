#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace coherency {

/// Something that is not divided when things are grouped by where they are.
struct GroupItem {
  glm::dvec3 low, high;     ///< box about it, m
  std::uint32_t triangles;  ///< what it counts for
};

/// The numbers of items that belong together: halves by the median along the axis on which their middles lie
/// farthest apart, until a group has no more than `triangles` and its box no side longer than `size` m, or is
/// a single item. What is longer than that by itself stands alone. Every item is in one group; the outcome
/// depends on nothing but the items.
std::vector<std::vector<std::uint32_t>> group(const std::vector<GroupItem>& items, std::size_t triangles,
                                              double size);

}  // namespace coherency
