#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/objects/Faces.h"

// What stands between a room and the next, or the open. Metres.

namespace coherency {

/// A wall as its room sees it, with rectangular openings and a skirting board. Its frame: origin on the floor
/// at the middle of the room side, x along the wall, y up, z into the room.
class Wall : public VRObject {
 public:
  struct Form {
    double width, height;
    std::uint32_t colour;
    /// Must not touch one another. One on the floor leads to another room, and parts the skirting; others are
    /// windows.
    std::vector<Outline> openings = {};
    double dado = 0.0;  ///< the wall has another colour up to here
    std::uint32_t dado_colour = 0;
    double skirting_inset = 0.0;  ///< at both ends, where another wall's board runs past
  };
  Wall(const Form& form, std::string name);

  static constexpr double kSkirtingDepth = 0.014;
  static constexpr double kThickness = 0.16;       ///< between two rooms; each has half of it
  static constexpr double kOuterThickness = 0.24;  ///< between a room and the open
  static constexpr double kArchitrave = 0.07;  ///< what a door's frame covers of the wall beside its opening

 private:
  void buildSurface(const Form& form);
  void buildSkirting(const Form& form);

  Polyhedron surface_;
  Polyhedron dado_;
  Polyhedron skirting_;
};

/// A wall in one colour, of a room that knows its size (Room.h).
Wall::Form plainWall(std::uint32_t colour, std::vector<Outline> openings = {});

/// An outer wall seen from the open, in the daylight: origin as a Wall's, z outwards, its openings the same
/// as the wall's. From the ground, which lies deeper than the floor, to a cornice.
class Facade : public VRObject {
 public:
  /// `corner`: another facade meets this one at its left end, in an inner corner; plinth and cornice stop
  /// before those of the other.
  Facade(double left, double right, const std::vector<Outline>& openings, bool corner = false);

  static constexpr double kGround = -0.4;  ///< m, height of the ground outside

 private:
  Polyhedron surface_;
  Polyhedron plinth_;
  Polyhedron cornice_;
};

/// The same opening, seen from the wall's other side.
Outline fromBehind(const Outline& opening);

}  // namespace coherency
