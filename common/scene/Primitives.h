#pragma once

#include "common/scene/Polygon.h"
#include "common/scene/Polyhedron.h"

// The primitives of paper section III.B, and Ellipsoid beside them. Sizes in metres; a size that is zero,
// negative or not finite is refused with std::invalid_argument naming it, and so are more than 1024 sides.
// setSize() may be called at any time: whoever compiled the old shape is told (ObjectWatch.h). Curved ones
// have coarser levels of detail, each with every other meridian of the one before, 6 or more.

namespace coherency {

/// Axis-parallel cuboid about the origin; 6 polygons.
class Box : public Polyhedron {
 public:
  explicit Box(const Coord3& size = {1.0, 1.0, 1.0}, std::string name = {});
  void setSize(const Coord3& size);
};

/// Cylinder, or cone frustum where the radii differ, about the y axis, centred on the origin;
/// `sides` (3 or more) quadrilaterals, or triangles where one end of a tapered one has radius zero (a cone),
/// and a polygon at each end that has a radius. Shaded smooth around, with sharp caps; with 3 or 4 sides
/// sharp all over.
class Cylinder : public Polyhedron {
 public:
  explicit Cylinder(double radius = 0.5, double height = 1.0, int sides = 24, std::string name = {});
  void setSize(double radius, double height, int sides = 24);
  void setTapered(double radius_bottom, double radius_top, double height, int sides = 24);
};

/// Ellipsoid with the given semi-axes about the origin; `sides` meridians (4 or more, even) by sides / 2
/// bands.
class Ellipsoid : public Polyhedron {
 public:
  explicit Ellipsoid(const Coord3& semi_axes = {0.5, 0.5, 0.5}, int sides = 16, std::string name = {});
  void setSize(const Coord3& semi_axes, int sides = 16);
};

/// width x height in the xy plane about the origin, seen from +z; 1 polygon.
class Rectangle : public Polygon {
 public:
  explicit Rectangle(double width = 1.0, double height = 1.0, std::string name = {});
  void setSize(double width, double height);
};

}  // namespace coherency
