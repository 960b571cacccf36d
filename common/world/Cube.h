#pragma once

#include "common/world/Plan.h"
#include "common/world/WorldState.h"

namespace coherency {

/// A movable that nobody holds, as geometry: world axes, its own centre as the origin. Metres.
class Cube {
 public:
  Cube(const Movable& movable, double edge);

  /// Of its centre.
  const BasePose& place() const { return place_; }
  double half() const { return half_; }

  /// From the centre down to the lowest corner.
  double lowest() const;
  /// Its most upright axis, turned upwards; unit.
  Coord3 up() const;
  /// It lies on one of its faces.
  bool isFlat() const;
  /// The square it covers when flat, seen from `origin`.
  PlanRectangle square(const BasePose& origin) const;
  /// How much higher its centre is than `other`.
  double above(const BasePose& other) const;

 private:
  double half_;
  TransformMatrix turn_;
  BasePose place_;
  int upright_ = 0;  ///< the column of turn_ that is the most upright axis
};

}  // namespace coherency
