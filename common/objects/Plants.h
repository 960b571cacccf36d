#pragma once

#include <array>

#include "common/objects/Faces.h"
#include "common/scene/Primitives.h"

// What grows, in rooms and outside. Origins on the ground. Metres.

namespace coherency {

/// Pot with long arching leaves, about 1 m high at `size` 1.
class Plant : public VRObject {
 public:
  explicit Plant(double size = 1.0);

 private:
  Cylinder pot_;
  Cylinder soil_;
  std::array<Polyhedron, 2> leaves_;  ///< of two tones
};

/// Round crown on a trunk, in daylight; about 4 m high.
class Tree : public VRObject {
 public:
  Tree();

 private:
  Cylinder trunk_;
  std::array<Ellipsoid, 2> crown_;
};

}  // namespace coherency
