#include "tests/render/CloseUp.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "common/math/FixedPoint.h"

namespace coherency {
namespace {

using Matrix2 = glm::mat<2, 2, Real>;

constexpr Real kDensity = 20.0L * 360.0L / static_cast<Real>(kTurn);  // px, of a tangent of 1
constexpr Real kPixel = 0.0025L;                                      // px, of the close-up
constexpr Real kHalf = 0.5L * kCloseUpSide;

/// How far out the edge lies that should go from the picture's middle along `edge`, pixels of the close-up;
/// all directions are of unit length. Very large where it is nowhere near.
Real outward(const Image& image, const Vector2& edge, const Vector2& out) {
  constexpr Real kNowhere = 1e9L;
  Real farthest_lit = -kNowhere;
  Real nearest_dark = kNowhere;
  for (int y = 0; y < kCloseUpSide; ++y)
    for (int x = 0; x < kCloseUpSide; ++x) {
      const Vector2 pixel(x + 0.5L - kHalf, kHalf - y - 0.5L);
      const Real distance = glm::dot(pixel, out);
      if (glm::dot(pixel, edge) < 0.5L * kHalf || std::abs(distance) > 0.25L * kHalf) continue;
      if (value(image, x, y, Green) > 0)
        farthest_lit = std::max(farthest_lit, distance);
      else
        nearest_dark = std::min(nearest_dark, distance);
    }
  return 0.5L * (farthest_lit + nearest_dark);
}

}  // namespace

std::vector<Corner> outline(const std::vector<Vector2>& seen) {
  // An edge of the outline has all that is seen on its left.
  const auto is_edge = [&](const Vector2& a, const Vector2& b) {
    return a != b && std::all_of(seen.begin(), seen.end(), [&](const Vector2& p) {
             return (b.x - a.x) * (p.y - a.y) >= (b.y - a.y) * (p.x - a.x);
           });
  };
  std::vector<Corner> corners;
  for (const Vector2& a : seen)
    for (const Vector2& b : seen)
      for (const Vector2& c : seen)
        if (is_edge(a, b) && is_edge(b, c)) corners.push_back({b, a, c});
  return corners;
}

EyeView closeUp(const EyeView& eye, const Vector2& middle) {
  const Real half = kHalf * kPixel / kDensity;
  EyeView view = eye;
  view.width = view.height = kCloseUpSide;
  view.view = {static_cast<double>(half - middle.x), static_cast<double>(half + middle.x),
               static_cast<double>(half - middle.y), static_cast<double>(half + middle.y)};
  return view;
}

Real error(const Image& close_up, const Corner& corner) {
  const Vector2 first = glm::normalize(corner.before - corner.at);
  const Vector2 second = glm::normalize(corner.after - corner.at);
  const Vector2 out_first = glm::normalize(glm::dot(second, first) * first - second);
  const Vector2 out_second = glm::normalize(glm::dot(first, second) * second - first);
  const Vector2 moved(outward(close_up, first, out_first), outward(close_up, second, out_second));
  return kPixel * glm::length(glm::inverse(glm::transpose(Matrix2(out_first, out_second))) * moved);
}

}  // namespace coherency
