#pragma once

#include <array>

#include "common/objects/Plants.h"

namespace coherency {

/// What is to be seen through the windows, whichever way they look: a garden on the ground outside
/// (Facade::kGround), hills all around, and the sky over everything. In daylight of its own. Its origin is
/// that of the building, whose outline the garden leaves free. Metres.
class Outdoors : public VRObject {
 public:
  Outdoors();

 private:
  static constexpr std::size_t kSkyBands = 8;
  static constexpr std::size_t kTrees = 9;

  void buildGarden();
  void buildHorizon();
  void plantTrees();

  Polyhedron lawn_;
  Polyhedron gravel_;
  Polyhedron hedge_;
  Polyhedron bench_;
  Polyhedron near_hills_;
  Polyhedron far_hills_;
  std::array<Polyhedron, kSkyBands> sky_;
  std::array<Tree, kTrees> trees_;
};

}  // namespace coherency
