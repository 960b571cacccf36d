#pragma once

#include <array>
#include <cstdint>

#include "common/scene/Primitives.h"

// What stands on furniture and hangs on walls. Standing things have their origins at the bottom, facing +z;
// hanging ones at the middle of the side at the wall. Metres.

namespace coherency {

/// Cube to build with.
class Block : public VRObject {
 public:
  static constexpr double kEdge = 0.055;

  Block(const std::string& name, std::uint32_t colour);

 private:
  Box cube_;
};

/// Computer screen on its foot, with a keyboard.
class Monitor : public VRObject {
 public:
  Monitor();

 private:
  Box case_;
  Rectangle screen_;
  std::array<Rectangle, 5> lines_;
  Box neck_;
  Box foot_;
  Box keyboard_;
};

class DeskLamp : public VRObject {
 public:
  DeskLamp();

 private:
  Cylinder foot_;
  Cylinder stem_;
  Cylinder arm_;
  Cylinder shade_;
  Ellipsoid bulb_;
};

class Mug : public VRObject {
 public:
  explicit Mug(std::uint32_t colour);

 private:
  Cylinder cup_;
  Cylinder coffee_;
  Box handle_;
};

/// Potted plant with long leaves.
class Plant : public VRObject {
 public:
  Plant();

 private:
  Cylinder pot_;
  Cylinder soil_;
  std::array<Ellipsoid, 11> leaves_;
};

class Globe : public VRObject {
 public:
  Globe();

 private:
  Cylinder foot_;
  Cylinder stem_;
  Ellipsoid ball_;
};

/// Board with a drawing in marker, and its tray.
class Whiteboard : public VRObject {
 public:
  Whiteboard();

 private:
  Box frame_;
  Rectangle surface_;
  std::array<Rectangle, 8> strokes_;
  Box tray_;
  Box pen_;
};

/// Two eyes that see one world: a print in a frame.
class Poster : public VRObject {
 public:
  Poster();

 private:
  Box frame_;
  Rectangle paper_;
  Rectangle band_;
  std::array<Polygon, 4> discs_;
  std::array<Rectangle, 3> text_;
};

class WallClock : public VRObject {
 public:
  WallClock();

 private:
  Cylinder rim_;
  Cylinder dial_;
  std::array<Box, 2> hands_;
};

}  // namespace coherency
