#pragma once

#include <array>

#include "common/scene/Primitives.h"
#include "common/world/Room.h"

// What fills a wall's openings, in the wall's frame, and what is to be seen through them. Metres.

namespace coherency {

/// Two panes in a frame, and a sill.
class Window : public VRObject {
 public:
  explicit Window(const Wall::Opening& opening);

 private:
  std::array<Box, 4> frame_;
  Box mullion_;
  Box sill_;
};

/// Closed leaf with a narrow pane and a handle, in its architrave; fills the opening it is given.
class Door : public VRObject {
 public:
  explicit Door(const Wall::Opening& opening);

 private:
  Box leaf_;
  Box pane_;
  Box kick_plate_;
  std::array<Box, 3> architrave_;
  Cylinder handle_;
  Cylinder handle_neck_;
};

/// A round crown on a trunk.
class Tree : public VRObject {
 public:
  Tree();

 private:
  Cylinder trunk_;
  Ellipsoid crown_;
  Ellipsoid crown_beside_;
};

/// Lawn, trees, hills and sky, ahead (-z) of the origin, which lies on the ground. In daylight of its own.
class Outdoors : public VRObject {
 public:
  Outdoors();

 private:
  static constexpr std::size_t kSkyBands = 6;

  Rectangle lawn_;
  Rectangle path_;
  Polyhedron near_hills_;
  Polyhedron far_hills_;
  std::array<Rectangle, kSkyBands> sky_;
  std::array<Tree, 4> trees_;
};

}  // namespace coherency
