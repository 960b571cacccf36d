#pragma once

#include <array>

#include "common/scene/VRObject.h"

namespace coherency {

// How a hand's joints bend as it closes. Human and robot hands share it, so that they hold things alike.
// Sizes are those of a right hand with kUnitHand from wrist to palm, others are scaled; frame:
// ArmKinematics.h; radians.

inline constexpr double kUnitHand = 0.09;  ///< m

/// Grip at which the fingers lie on a cube, those of the far side on one face and the thumb on the one
/// opposite. The cube's edge is kHeldEdge, its faces are along the hand's axes, its centre at x = kUnitHand,
/// y = -kHeldBelow.
inline constexpr double kHoldingGrip = 0.60;
inline constexpr double kHeldEdge = 0.055;    ///< m
inline constexpr double kHeldBelow = 0.0625;  ///< m

/// Three segments on a knuckle.
struct FingerShape {
  const char* name;
  Coord3 knuckle;
  double spread;  ///< towards the little finger's side, open
  double rest;    ///< how much more it curls at rest than the index finger, a factor
  std::array<double, 3> length;
  double radius;
};

/// Spread of the knuckle, and bend of the three joints towards the palm.
struct FingerBend {
  double spread;
  std::array<double, 3> curl;
};
/// `grip` 0 open, naturally curled, to 1 a closed fist; what lies beyond is taken as the nearer end.
FingerBend fingerBend(const FingerShape& finger, double grip);

/// Of the thumb's two joints: down from the hand's x axis towards the palm's side, and across, away from the
/// palm's middle.
struct ThumbBend {
  double down;
  double across;
  double tip_down;
  double tip_across;
};
ThumbBend thumbBend(double grip);

/// Turns the segments, each a member of the one before; `side` is +1 for a right hand, -1 for a left.
void bendFinger(const FingerBend& bend, double side, const std::array<VRObject*, 3>& segments);
void bendThumb(const ThumbBend& bend, double side, VRObject& proximal, VRObject& distal);

}  // namespace coherency
