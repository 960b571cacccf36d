#include "common/body/master/MasterLayout.h"

#include <algorithm>

#include "common/body/Limbs.h"
#include "common/body/master/Joystick.h"
#include "common/body/master/Pedal.h"

namespace coherency {

namespace {

/// Middle of the left hand's grip when the elbow hangs at the side.
Coord3 handleAtRest(const Rig& rig) {
  const double elbow = rig.seat_height + rig.trunk_length - rig.shoulder_drop - rig.upper_arm;
  return {-rig.shoulder_half_width - 0.075, std::max(rig.seat_height + 0.1, elbow + 0.07),
          -rig.forearm - 0.03};
}

Coord3 pedalHinge(const Rig& rig, double side, double deck_top) {
  const Coord3 ankle = Pedal::ankleOffset(rig.foot, LegShape::ankleHeight(rig));
  const double y = std::max(deck_top + 0.02, rig.seat_height - 0.85 * rig.shin - ankle.y);
  return {side * (rig.hip_half_width + 0.02), y, -(rig.thigh + 0.66 * rig.shin) - ankle.z};
}

}  // namespace

MasterLayout::MasterLayout(const Rig& rig) {
  deck_bottom = 0.022;
  deck_top = 0.060;
  joystick = handleAtRest(rig) - Coord3{0.0, Joystick::handleHeight(), 0.0};
  pedal_left = pedalHinge(rig, -1.0, deck_top);
  pedal_right = pedalHinge(rig, 1.0, deck_top);
  deck_half_width = 0.03 - joystick.x;
  deck_ahead = Pedal::length(rig.foot) - pedal_right.z;
  deck_behind = 0.29;
  seat_top = rig.seat_height - 0.068;  // a thigh's half under the hip joints
  seat_half_width = std::max(0.21, rig.hip_half_width + 0.11);
  back_height = std::max(0.3, 0.88 * rig.trunk_length);
  mast_top = {0.0, rig.seat_height + std::max(0.35, rig.trunk_length), 0.265};
  exoskeleton = {rig.shoulder_half_width + 0.11, rig.seat_height + 0.58 * rig.trunk_length, 0.235};
}

double armGirth(const Rig& rig) {
  return (rig.upper_arm + rig.forearm) / 0.55;
}

}  // namespace coherency
