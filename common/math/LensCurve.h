#pragma once

#include <array>
#include <optional>

namespace coherency {

/// How a lens spreads one colour of a panel: what is shown at distance r from the lens centre is seen at the
/// tangent r * s(r), with s(r) = c[0] + c[1] r^2 + c[2] r^4 + c[3] r^6 + c[4] r^8, or r / s(r) where the
/// curve is reciprocal. Lens.h gives r and the tangent their units.
///
/// The radial part of Brown's model (Close-range camera calibration, 1971) from the panel to the eye: the
/// direction in which a correction is drawn, and makers publish their lenses. Even powers, as a lens is
/// smooth at its centre.
struct LensCurve {
  std::array<double, 5> c{1.0, 0.0, 0.0, 0.0, 0.0};
  bool reciprocal = false;

  double tangent(double r) const;
  /// Of tangent() over r.
  double slope(double r) const;
  /// Whether tangent() is finite and rises all the way from 0 to `r_max`, as it must to have an inverse. Not
  /// sampled: its slope's sign is that of a polynomial, whose Bernstein coefficients on ever smaller
  /// intervals bound it (Farouki, The Bernstein polynomial basis: a centennial retrospective, 2012).
  bool risesUpTo(double r_max) const;
  /// The r of 0..r_max at which `tangent` is seen; none where that is beyond it. Newton's steps, halving the
  /// interval where one leaves it. Precondition: risesUpTo(r_max).
  std::optional<double> radius(double tangent, double r_max) const;
};

}  // namespace coherency
