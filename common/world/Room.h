#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/scene/Primitives.h"

// What encloses a room. Metres.

namespace coherency {

/// Square tiles of two tones about the origin, in the plane y = 0; width along x and depth along z are whole
/// numbers of tiles.
class Floor : public VRObject {
 public:
  Floor(int tiles_x, int tiles_z, double tile);

 private:
  Polyhedron light_;
  Polyhedron dark_;
};

/// Seen from below; hangs at this object's origin.
class Ceiling : public VRObject {
 public:
  Ceiling(double width, double depth);

 private:
  Rectangle board_;
};

/// Shining panel in a frame, hung under its origin.
class CeilingLamp : public VRObject {
 public:
  CeilingLamp(double width, double depth);

 private:
  Box frame_;
  Box panel_;
};

/// A wall with rectangular openings and a skirting board. Its frame: origin on the floor at the middle of the
/// room side, x along the wall, y up, z into the room.
class Wall : public VRObject {
 public:
  struct Opening {
    double left, right, bottom, top;
  };
  struct Form {
    double width, height;
    std::uint32_t colour;
    double skirting_inset = 0.0;  ///< at both ends, where another wall's board runs past
    std::vector<Opening> openings =
        {};  ///< must not touch one another; one that begins at the floor parts the skirting
  };
  Wall(const Form& form, std::string name);

  static constexpr double kThickness = 0.16;

 private:
  void buildSurface(const Form& form);
  void buildSkirting(const Form& form);

  Polyhedron surface_;
  std::array<Box, 2> skirting_;
};

}  // namespace coherency
