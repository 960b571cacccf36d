#pragma once

#include <vector>

#include "common/body/Rig.h"

namespace coherency {

/// An upright cylinder that a vehicle takes up, relative to its base (origin on the floor, y up, -z ahead).
struct FootprintDisc {
  double x = 0.0;
  double z = 0.0;
  double radius = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// The master system with the operator on it: the seat and the joystick, as high as the head of somebody
/// sitting, and the legs and pedals ahead of them, which go under a table. Metres. Whatever is drawn of it
/// below the head stays within (to 5 cm), but for the right arm and what measures that.
std::vector<FootprintDisc> masterFootprint(const Rig& rig);

/// The slave robot, of the size of `robot_rig`; likewise.
std::vector<FootprintDisc> robotFootprint(const Rig& robot_rig);

}  // namespace coherency
