#pragma once

#include <cstdint>

#include "common/math/FixedPoint.h"
#include "common/objects/Wall.h"
#include "common/scene/Primitives.h"

// What encloses a room, and how its things are put into it. Metres.

namespace coherency {

/// Which way something turns that faces the back of the room (+z) as it is made; radians about y.
inline constexpr double kFacesBack = 0.0;
inline constexpr double kFacesRight = kTurn / 4;
inline constexpr double kFacesLeft = -kTurn / 4;
inline constexpr double kFacesFront = kTurn / 2;

/// Makes `part`, a data member of `owner`'s class, stand at `at`, turned to the left by `turn`.
void put(VRObject& owner, VRObject& part, const Coord3& at, double turn = kFacesBack);

/// A floor about the origin, in the plane y = 0: square tiles of two tones.
class TiledFloor : public VRObject {
 public:
  TiledFloor(double width, double depth, double tile, std::uint32_t light, std::uint32_t dark,
             double gloss = 0.0);

 private:
  Polyhedron light_;
  Polyhedron dark_;
};

/// The same as sheets: a field with a border along the walls.
class BorderedFloor : public VRObject {
 public:
  BorderedFloor(double width, double depth, double border, std::uint32_t field, std::uint32_t edge);

 private:
  Polyhedron field_;
  Polyhedron edge_;
};

/// Four walls and a ceiling around a room about the origin, an Enclosure with the floor that is put below:
/// front is -z, right is +x. Each wall's width and height come from the room's.
class Shell : public VRObject {
 public:
  struct Form {
    double width, depth, height;  ///< along x, z, y
    Wall::Form front, back, left, right;
  };
  explicit Shell(const Form& form);

  Wall& front() { return front_; }
  Wall& back() { return back_; }
  Wall& left() { return left_; }
  Wall& right() { return right_; }

 private:
  Wall front_;
  Wall back_;
  Wall left_;
  Wall right_;
  Rectangle ceiling_;
};

}  // namespace coherency
