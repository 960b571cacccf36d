#pragma once

namespace coherency {

/// Where baking trades accuracy for time.
struct BakeSettings {
  /// For the light at a vertex (LightBaker); 8 or more. Four times as many make a third of the error and take
  /// more than twice the time (docs/measurements.md). 0: each surface is lit as if it stood alone, at the
  /// vertices it has, and nothing is cut; for measuring what is too large to be baked.
  int rays = 16;
  /// An edge is cut where what is shown halfway differs from what is shown halfway between its ends', times
  /// the edge's length, by more than this: share of a display's range, times m.
  double tolerance = 0.012;
  double finest = 0.04;  ///< m; edges as short as this are not cut for light
};

}  // namespace coherency
