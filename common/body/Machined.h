#pragma once

#include <vector>

#include "common/body/Loft.h"
#include "common/scene/Polyhedron.h"

// Parts of machines, of few and plane polygons. Metres and radians. Ends that are never seen, as another part
// covers them, are left open: no polygon is drawn for nothing. Shapes that cannot be, such as sections that
// do not advance along the axis or extents that are not positive, are refused with std::invalid_argument.

namespace coherency {

/// Which ends of a part have a polygon: the first is the one the axis comes from.
enum class Ends { Open, First, Last, Both };

/// Body of revolution about an axis through the origin, of regular polygons: drums, wheels, lenses.
class Turned : public Polyhedron {
 public:
  struct Ring {
    double at;      ///< along the axis
    double radius;  ///< of the corners
  };

  /// `sides` quadrilaterals between each two rings; 3 sides or more. With 8 sides or more it is shaded round.
  void setProfile(Loft::Along along, int sides, const std::vector<Ring>& rings, Ends ends);
};

/// Rectangles with their corners cut at 45 degrees, stacked along an axis: bars, housings, cushions. Sections
/// are as Loft's.
class Milled : public Polyhedron {
 public:
  /// `chamfer`: what is cut off each corner over the smaller half extent, 0 (4 sides) to below 1 (8 sides).
  void setSections(Loft::Along along, double chamfer, const std::vector<Loft::Section>& sections, Ends ends);
  /// Bar along x from the origin, of one section, corners uncut; half extents across it.
  void setBar(double length, double half_y, double half_z, Ends ends);
};

/// Corners of the first and the last ring of such a part, as a polygon seen from outside: what closes an open
/// end in another colour. `sides`: corners a ring.
std::vector<Coord3> firstRing(const Polyhedron& part, std::size_t sides);
std::vector<Coord3> lastRing(const Polyhedron& part, std::size_t sides);

/// Stretch of a ring about an axis through the origin, open towards what it goes around.
class Arc : public Polyhedron {
 public:
  struct Form {
    double inner;       ///< radius of the corners
    double outer;       ///< > inner
    double half_width;  ///< along the axis
    double from;        ///< angle about the axis, from the axis that follows it in the cycle x, y, z
    double to;          ///< > from, at most a turn on
    int segments;       ///< each of 4 polygons
  };

  /// About the axis, in the plane at 0 along it.
  void setForm(Loft::Along along, const Form& form, Ends ends);
};

}  // namespace coherency
