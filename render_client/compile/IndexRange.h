#pragma once

#include <cstdint>
#include <vector>

namespace coherency {

/// Where triangles lie in a pair of buffers.
struct IndexRange {
  std::uint32_t first_index = 0;
  std::uint32_t index_count = 0;
  std::uint32_t first_vertex = 0;  ///< indices count from it
  bool operator==(const IndexRange&) const = default;
};

/// A coarser form of something drawn: other triangles over the same vertices.
struct LevelRange {
  std::uint32_t first_index;
  std::uint32_t index_count;
  double error;  ///< how far it lies from the finest at most, m
};

/// The coarsest that lies no farther than `error` m from the finest. `coarser`: errors rise.
inline IndexRange coarsestWithin(double error, const IndexRange& finest,
                                 const std::vector<LevelRange>& coarser) {
  IndexRange range = finest;
  for (const LevelRange& level : coarser) {
    if (!(level.error <= error)) break;
    range.first_index = level.first_index;
    range.index_count = level.index_count;
  }
  return range;
}

}  // namespace coherency
