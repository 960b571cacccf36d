#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/body/ArmKinematics.h"
#include "common/body/Footprint.h"
#include "common/world/BasePose.h"

namespace coherency {

/// Limits of driving by joystick (stick_y ahead, stick_x sideways, stick_twist turns; twist is positive to
/// the left). Left pedal brakes, right pedal raises the speed up to `boost`.
struct DriveLimits {
  double speed = 0.8;              ///< m/s at full stick
  double boost = 2.0;              ///< speed factor at full right pedal
  double turn_rate = 0.8;          ///< rad/s at full twist
  double acceleration = 1.5;       ///< m/s^2
  double turn_acceleration = 3.0;  ///< rad/s^2
  double brake = 6.0;              ///< m/s^2 at full left pedal
};

/// A box that stands in the world, turned about the vertical: what stops driving and carries what is put
/// down.
struct SolidBox {
  BasePose centre;  ///< of its bottom
  double half_x = 0.0;
  double half_z = 0.0;
  double height = 0.0;
  std::string owner;    ///< path of the object it belongs to, for messages
  int member = 0;       ///< which of the scene's members that is part of
  double cosine = 1.0;  ///< of the heading; see place()
  double sine = 0.0;
};

struct DoorModel {
  SolidBox barrier;     ///< in the way until the door is open
  double sensor = 0.0;  ///< m, from the barrier's middle
};

/// What drives, and whose posture it carries.
struct VehicleModel {
  std::vector<FootprintDisc> footprint;
  DriveLimits limits;
  BasePose start;
  Rig rig;
  double scale = 1.0;  ///< of the operator's lengths: how the head's motion is mapped
};

/// A cube that can be grasped, where it is when the world begins.
struct MovableModel {
  double edge = 0.0;  ///< m
  BasePose start;     ///< of its centre
  std::string name;
  int member = 0;  ///< which of the scene's
};

/// What never changes while a world runs and its steps go by: sizes, places, limits. Plain data, made from a
/// scene's attributes (Scene.h) or by hand.
struct WorldModel {
  VehicleModel master;
  std::optional<VehicleModel> robot;  ///< none: there is no robot mode
  std::vector<SolidBox> solids;
  std::vector<DoorModel> doors;        ///< at most kMaxDoors
  std::vector<MovableModel> movables;  ///< at most kMaxMovables
  bool driving = true;                 ///< false: stick and pedals move nothing
};

}  // namespace coherency
