#include "render_client/cull/ViewPyramid.h"

#include <algorithm>
#include <limits>

namespace coherency {
namespace {

/// Of a distance: what float arithmetic can move a vertex by, several operations deep.
constexpr double kRounding = 4e-6;

}  // namespace

ViewPyramid::ViewPyramid(const TransformMatrix& t_world_eye, const FieldOfView& view, double near_m)
    : eye_(t_world_eye.origin()), ahead_(t_world_eye.vector({0.0, 0.0, -1.0})), near_(near_m) {
  const std::array<Coord3, 4> sides = {Coord3{1.0, 0.0, -view.tan_left}, Coord3{-1.0, 0.0, -view.tan_right},
                                       Coord3{0.0, 1.0, -view.tan_down}, Coord3{0.0, -1.0, -view.tan_up}};
  std::transform(sides.begin(), sides.end(), inward_.begin(),
                 [&](const Coord3& side) { return t_world_eye.vector(normalized(side)); });
}

InView ViewPyramid::sees(const Sphere& sphere) const {
  const Coord3 from_eye = sphere.centre - eye_;
  const double reach = sphere.radius + kRounding * (norm(from_eye) + sphere.radius);
  double least = dot(from_eye, ahead_) - near_;
  for (const Coord3& inward : inward_) least = std::min(least, dot(from_eye, inward));
  if (least < -reach) return InView::None;
  return least > reach && reach < std::numeric_limits<double>::infinity() ? InView::All : InView::Part;
}

InView ViewPyramids::sees(const Sphere& sphere) const {
  InView most = views_.empty() ? InView::All : InView::None;
  for (const ViewPyramid& view : views_) most = std::max(most, view.sees(sphere));
  return most;
}

}  // namespace coherency
