#pragma once

#include <algorithm>
#include <cmath>

#include "common/body/Palette.h"
#include "common/body/Rig.h"

namespace coherency {

/// How large the robot's parts are over those that fit the default rig. Each is a multiple of the rig's
/// measures, so that a rig of another scale makes the same robot of that scale, every vertex of it.
struct RobotSize {
  explicit RobotSize(const Rig& rig)
      : trunk(rig.trunk_length / 0.52),
        wide(rig.shoulder_half_width / 0.19),
        arm((rig.upper_arm + rig.forearm) / 0.55),
        hand(rig.hand / 0.09),
        head(std::max(
            {rig.eye_forward / 0.085, rig.eye_distance / 0.064, std::abs(rig.eye_up) / 0.03, 0.8 * trunk})) {}

  double trunk;
  double wide;  ///< across the shoulders
  double arm;
  double hand;
  double head;  ///< holds the eyes
};

/// What the robot is painted with.
namespace robot_paint {
inline Material hull() {
  return paint(0xE9E6DC, 0.25);
}
inline Material joint() {
  return paint(0x363C42, 0.3);
}
inline Material metal() {
  return paint(0x9AA2A8, 0.5);
}
inline Material accent() {
  return paint(0xE0A22E, 0.2);
}
inline Material rubber() {
  return paint(0x232628);
}
inline Material lens() {
  return paint(0x16324A, 0.95);
}
}  // namespace robot_paint

}  // namespace coherency
