#pragma once

#include <vector>

#include "common/scene/Polyhedron.h"

namespace coherency {

/// Smooth closed body through oval cross sections stacked along an axis: limbs, trunks, shoes, cushions.
/// Metres. A section is the superellipse |u/a|^n + |v/b|^n = 1, `a` along the axis that follows the loft's in
/// the cycle x, y, z and `b` along the one after; its points are spread evenly over the directions of the
/// outward normal, which keeps flat ovals smooth.
class Loft : public Polyhedron {
 public:
  enum class Along { X, Y, Z };

  struct Section {
    double at;  ///< along the axis
    double a;   ///< half extent, > 0
    double b;   ///< half extent, > 0
    double centre_a = 0.0;
    double centre_b = 0.0;
  };
  struct Form {
    Along along = Along::Y;
    int sides = 12;           ///< points a section, 3 or more
    double squareness = 2.0;  ///< exponent n: 2 an ellipse, larger boxier; > 1
    double dome_first = 0.0;  ///< length of the rounded end before the first section; 0 a flat end
    double dome_last = 0.0;   ///< and after the last
  };

  Loft() = default;

  /// Throws std::invalid_argument for fewer than two sections, sections that do not advance along the axis,
  /// half extents that are not positive, or a form out of its ranges.
  void setSections(const std::vector<Section>& sections, const Form& form);
};

/// The point `at` along the axis, and `a` and `b` along the two that follow it in the cycle x, y, z.
Coord3 onAxes(Loft::Along along, double at, double a, double b);

}  // namespace coherency
