#pragma once

#include <array>

#include "common/objects/Faces.h"
#include "common/scene/Primitives.h"

// What hangs on the walls of rooms, in front of them: origin at the middle of the side at the wall, z into
// the room. Metres.

namespace coherency {

/// Ten past nine; it ticks.
class WallClock : public VRObject {
 public:
  WallClock();

 private:
  Cylinder rim_;
  Cylinder dial_;
  Polyhedron marks_;
  std::array<Box, 2> hands_;
};

/// Heating under a window; its origin is on the floor, at the wall.
class Radiator : public VRObject {
 public:
  explicit Radiator(double width);

 private:
  Polyhedron fins_;
  Polyhedron pipes_;
};

/// Grille through which air comes; it is heard.
class AirVent : public VRObject {
 public:
  AirVent();

 private:
  Polyhedron frame_;
  Rectangle dark_;
  Polyhedron slats_;
};

}  // namespace coherency
