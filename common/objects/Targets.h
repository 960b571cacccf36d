#pragma once

#include <array>

#include "common/body/VirtualHuman.h"
#include "common/scene/Primitives.h"

namespace coherency {

/// For checking registration: shining balls on black, each of a colour of its own. Red, yellow and cyan stand
/// 0.5, 1 and 5 m ahead of the plane of the eyes of an operator in the neutral posture at the start, at the
/// same apparent size, the nearest lowest; magenta is carried at the right wrist (the hand frame's origin),
/// green at the palm. For an operator that is not shown, at the origin.
class Targets : public VRObject {
 public:
  Targets(const Rig& rig, VirtualHuman& human);

  static constexpr std::array<double, 3> kDistances = {0.5, 1.0, 5.0};  ///< m
  static constexpr double kAngularRadius = 0.012;                       ///< of those, radius over distance
  static constexpr double kHandRadius = 0.006;                          ///< m

 private:
  std::array<Ellipsoid, 3> ahead_;
  Ellipsoid wrist_;
  Ellipsoid palm_;
};

}  // namespace coherency
