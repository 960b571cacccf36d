#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "tests/render/Support.h"

// Where a corner is in a picture, to a thousandth of a pixel: seen through a close-up, the same eye with a
// field of view of 0.32 px about where it should be, on 128x128 px.

namespace coherency {

using Real = long double;
using Vector2 = glm::vec<2, Real>;
using Vector3 = glm::vec<3, Real>;
using Matrix3 = glm::mat<3, 3, Real>;
using Matrix4 = glm::mat<4, 4, Real>;

/// A corner of a convex outline and those beside it: tangents from the optical axis, to the right and up.
struct Corner {
  Vector2 at;
  Vector2 before;
  Vector2 after;
};
/// Of all that is seen, counter-clockwise. Precondition: no three of its points are on one line.
std::vector<Corner> outline(const std::vector<Vector2>& seen);

inline constexpr int kCloseUpSide = 128;  ///< pixels
/// The view of the same eye onto the surroundings of a place in its picture, 20 px a degree.
EyeView closeUp(const EyeView& eye, const Vector2& middle);
/// How far from the close-up's middle, where it should be, the corner is, px of the eye's picture: where its
/// two edges meet. Inside the outline there is green, outside of it none. Some thousands where an edge is
/// not to be seen within 0.04 px.
Real error(const Image& close_up, const Corner& corner);

}  // namespace coherency
