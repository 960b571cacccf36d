#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/math/Frustum.h"

namespace coherency {

/// How much of a sphere may be in view.
enum class InView : std::uint8_t { None, Part, All };

/// What an eye takes in, as the half spaces in front of it (block clipping, paper, section III.C.2). Never
/// wrong: None is said only of what shows in no pixel, whatever the rounding of the vertices that a GPU
/// computes in float; Part may also be said of what stands beside the view.
class ViewPyramid {
 public:
  /// `t_world_eye` is rigid; nothing nearer than `near_m` is seen, and everything beyond.
  ViewPyramid(const TransformMatrix& t_world_eye, const FieldOfView& view, double near_m);

  /// World coordinates, m. Part where the sphere is not finite.
  InView sees(const Sphere& sphere) const;

 private:
  Coord3 eye_;
  Coord3 ahead_;
  double near_;
  std::array<Coord3, 4> inward_;  ///< normals of the sides, which all hold the eye
};

/// What the views of one frame take in together.
class ViewPyramids {
 public:
  void clear() { views_.clear(); }
  void add(const ViewPyramid& view) { views_.push_back(view); }
  /// Part also where views each see another part. All where there are no views: then nothing is clipped.
  InView sees(const Sphere& sphere) const;

 private:
  std::vector<ViewPyramid> views_;
};

}  // namespace coherency
