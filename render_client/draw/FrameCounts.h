#pragma once

#include <cstddef>

namespace coherency {

/// What a frame had in it.
struct FrameCounts {
  std::size_t moving = 0;        ///< drawables that move
  std::size_t fixed_shaded = 0;  ///< blocks of what does not, near enough to what does for its shadows
  std::size_t fixed_plain = 0;   ///< the others: a pixel of theirs costs next to nothing
  std::size_t triangles = 0;     ///< of all these, in each view
};

}  // namespace coherency
