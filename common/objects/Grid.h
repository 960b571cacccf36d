#pragma once

#include <memory>
#include <vector>

#include "common/scene/Primitives.h"

namespace coherency {

/// Boxes of many colours and sizes on a square lattice, for measuring: what a frame costs by the number of
/// objects. They stand on the floor ahead (-z) of the origin, a metre apart, row behind row; as many columns
/// as rows.
class Grid : public VRObject {
 public:
  static constexpr double kSpacing = 1.0;  ///< m
  static constexpr double kFirst = 2.0;    ///< m, from the origin to the first row

  explicit Grid(int count);

 private:
  std::vector<std::unique_ptr<Box>> boxes_;
};

}  // namespace coherency
