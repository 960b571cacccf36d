#pragma once

#include <array>
#include <optional>

#include "common/math/Frustum.h"
#include "common/math/LensCurve.h"

namespace coherency {

/// Direction from an eye: tangents right and up of its optical axis (-z).
struct Direction {
  double right = 0.0;
  double up = 0.0;
};

/// The lens between an eye and its panel, alike in all directions about its centre, where the optical axis
/// meets the panel (after Robinett and Rolland, A computational model for the stereoscopic optics of a
/// head-mounted display, 1992). Panel pixels are counted from its top left corner, x right, y down, and are
/// square; pixel centres at .5.
struct Lens {
  double centre_x = 0.0;  ///< panel pixels
  double centre_y = 0.0;
  double unit_px = 1.0;             ///< panel pixels of r = 1
  double tangent = 1.0;             ///< that a curve's 1 stands for
  double radius = 1.0;              ///< of what the lens shows, in r; the panel stays black beyond
  std::array<LensCurve, 3> curves;  ///< red, green, blue

  /// Where a point of the panel is seen in that colour; beyond `radius` as if the curve went on straight.
  Direction seen(std::size_t colour, const PixelPoint& shown) const;
  /// The point of the panel that is seen there; none beyond `radius`.
  std::optional<PixelPoint> shown(std::size_t colour, const Direction& seen) const;
  /// Panel pixels of a tangent of 1 at the lens centre.
  double pixelsPerTangent() const;
  /// The smallest field of view that has in it all that the lens shows of a panel of that size, in all
  /// colours. Throws std::domain_error where the lens centre is not on the panel.
  FieldOfView view(int panel_width, int panel_height) const;
};

}  // namespace coherency
