#pragma once

#include "common/math/Frustum.h"

namespace coherency {

/// Where both eyes judge from how much detail a thing needs: one point, so that an eye that is drawn on a
/// machine of its own judges as the other one does.
struct CyclopeanEye {
  Coord3 position;          ///< halfway between the eyes, in the world, m
  double eye_offset = 0.0;  ///< of each eye from there, m
  double pixels = 0.0;      ///< of a picture, for a tangent of 1
};

/// How coarse things may be in a frame, in pixels as they are in the middle of an eye's picture: in truth
/// angles, so that turning the head changes nothing. Towards the border of a flat picture things are drawn
/// larger, by up to 1 / cos^2 of the angle from its middle.
class DetailChoice {
 public:
  /// All of everything.
  DetailChoice() = default;
  /// `detail_px`: how far what is drawn may lie from the finest; `smallest_px`: what is smaller across is
  /// left out. Neither is exceeded for either eye.
  DetailChoice(const CyclopeanEye& eye, double detail_px, double smallest_px)
      : eye_(eye), detail_(detail_px / eye.pixels), smallest_(smallest_px / eye.pixels) {}

  /// m: by how much the surface of what is in the sphere may be off. Rises with distance; 0 in the sphere.
  double allowedError(const Sphere& sphere) const { return detail_ * nearest(sphere); }
  bool tooSmall(const Sphere& sphere) const {
    return smallest_ > 0.0 && 2.0 * sphere.radius < smallest_ * nearest(sphere);
  }

 private:
  /// m; from an eye to the sphere, at least.
  double nearest(const Sphere& sphere) const;

  CyclopeanEye eye_;
  double detail_ = 0.0;  ///< tangents
  double smallest_ = 0.0;
};

}  // namespace coherency
