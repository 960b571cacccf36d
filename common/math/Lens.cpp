#include "common/math/Lens.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace coherency {
namespace {

/// Angles about the lens centre between which the border of what is shown has no corner, and some between.
std::vector<double> borderAngles(const Lens& lens, double left, double right, double up, double down) {
  constexpr int kBetween = 4096;
  std::vector<double> angles;
  angles.reserve(kBetween + 20);
  for (int i = 0; i < kBetween; ++i) angles.push_back(2.0 * std::numbers::pi * i / kBetween);
  for (const double x : {-left, right})
    for (const double y : {-down, up}) {
      angles.push_back(std::atan2(y, x));
      const double rest_x = std::sqrt(std::max(0.0, lens.radius * lens.radius - x * x));
      const double rest_y = std::sqrt(std::max(0.0, lens.radius * lens.radius - y * y));
      for (const double sign : {-1.0, 1.0}) {  // where the panel's border and the lens's cross
        angles.push_back(std::atan2(sign * rest_x, x));
        angles.push_back(std::atan2(y, sign * rest_y));
      }
    }
  return angles;
}

}  // namespace

Direction Lens::seen(std::size_t colour, const PixelPoint& shown) const {
  const double x = (shown.x - centre_x) / unit_px;
  const double y = (centre_y - shown.y) / unit_px;
  const double r = std::hypot(x, y);
  const LensCurve& curve = curves[colour];
  if (r == 0.0) return {};
  const double bent =
      r <= radius ? curve.tangent(r) : curve.tangent(radius) + curve.slope(radius) * (r - radius);
  return {tangent * bent * x / r, tangent * bent * y / r};
}

std::optional<PixelPoint> Lens::shown(std::size_t colour, const Direction& seen) const {
  const double bent = std::hypot(seen.right, seen.up);
  if (bent == 0.0) return PixelPoint{centre_x, centre_y};
  const auto r = curves[colour].radius(bent / tangent, radius);
  if (!r) return std::nullopt;
  return PixelPoint{centre_x + unit_px * *r * seen.right / bent, centre_y - unit_px * *r * seen.up / bent};
}

double Lens::pixelsPerTangent() const {
  double sharpest = 0.0;
  for (const LensCurve& curve : curves) sharpest = std::max(sharpest, unit_px / (tangent * curve.slope(0.0)));
  return sharpest;
}

FieldOfView Lens::view(int panel_width, int panel_height) const {
  const double left = centre_x / unit_px;
  const double right = (panel_width - centre_x) / unit_px;
  const double up = centre_y / unit_px;
  const double down = (panel_height - centre_y) / unit_px;
  if (!(left > 0.0 && right > 0.0 && up > 0.0 && down > 0.0))
    throw std::domain_error("the lens centre must lie on the panel");
  FieldOfView view{0.0, 0.0, 0.0, 0.0};
  // A curve rises, so what is seen farthest in any direction is on the border.
  for (const double angle : borderAngles(*this, left, right, up, down)) {
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    const double r =
        std::min({radius, (x > 0.0 ? right : left) / std::abs(x), (y > 0.0 ? up : down) / std::abs(y)});
    for (const LensCurve& curve : curves) {
      const double bent = tangent * curve.tangent(r);
      view.tan_right = std::max(view.tan_right, bent * x);
      view.tan_left = std::max(view.tan_left, -bent * x);
      view.tan_up = std::max(view.tan_up, bent * y);
      view.tan_down = std::max(view.tan_down, -bent * y);
    }
  }
  return view;
}

}  // namespace coherency
