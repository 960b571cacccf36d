#include "bench/peers/SeenTriangles.h"

namespace coherency {

bool TriangleFilter::passes(const std::array<Coord3, 3>& corners) const {
  const Coord3 p[3] = {t_eye_mesh.point(corners[0]), t_eye_mesh.point(corners[1]),
                       t_eye_mesh.point(corners[2])};
  const auto all = [&](auto&& beyond) { return beyond(p[0]) && beyond(p[1]) && beyond(p[2]); };
  const FieldOfView& sides = view.view;
  return !(all([&](const Coord3& v) { return v.x < v.z * sides.tan_left; }) ||
           all([&](const Coord3& v) { return -v.x < v.z * sides.tan_right; }) ||
           all([&](const Coord3& v) { return v.y < v.z * sides.tan_down; }) ||
           all([&](const Coord3& v) { return -v.y < v.z * sides.tan_up; }) ||
           all([&](const Coord3& v) { return v.z > -view.near_m; }));
}

}  // namespace coherency
