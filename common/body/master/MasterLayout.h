#pragma once

#include "common/body/Rig.h"

namespace coherency {

/// Where the parts of the master system stand so that they fit the operator: points in the body frame,
/// lengths in metres.
struct MasterLayout {
  explicit MasterLayout(const Rig& rig);

  double deck_bottom;  ///< of the mobile platform, over the floor
  double deck_top;
  double deck_half_width;
  double deck_ahead;   ///< reach ahead of the origin
  double deck_behind;  ///< and behind it
  double seat_top;     ///< of the cushion
  double seat_half_width;
  double back_height;  ///< of the seat's back, over the hips
  Coord3 joystick;     ///< pivot of the stick
  Coord3 pedal_left;   ///< hinges
  Coord3 pedal_right;
  Coord3 mast_top;     ///< behind the seat's back: root of the head's linkage
  Coord3 exoskeleton;  ///< where its carrier is hinged, behind the right shoulder
};

/// How thick an arm is over the default operator's: joints and links beside it keep their distance by it.
double armGirth(const Rig& rig);

}  // namespace coherency
