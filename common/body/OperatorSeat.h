#pragma once

#include <array>

#include "common/body/Loft.h"
#include "common/body/Rig.h"
#include "common/scene/Primitives.h"

namespace coherency {

/// Stick on the left arm rest, about a pivot that is its origin; y up the stick at rest. Body axes.
class Joystick : public VRObject {
 public:
  Joystick();

  /// Each -1..1: to the right, ahead, and twisted to the left.
  void set(double x, double y, double twist);
  /// Middle of the handle over the pivot, m.
  static double handleHeight();
  /// Turns with the stick; origin at the middle of the handle.
  const VRObject& handle() const { return handle_; }

 private:
  Cylinder boot_;
  VRObject stick_{"joystick stick"};
  Cylinder shaft_;
  VRObject handle_{"joystick handle"};
  Loft grip_;
  Ellipsoid button_;
};

/// Pedal hinged at the heel, its origin; -z along the plate. Body axes.
class Pedal : public VRObject {
 public:
  explicit Pedal(const std::string& name);

  void set(double pressed);  ///< 0 released .. 1 down
  /// Ankle of a foot that rests on it, in the pedal's parent's frame, toes along -z of it.
  TransformMatrix foot(double ankle_height) const;
  /// Where that ankle is from the hinge, half pressed.
  static Coord3 ankleOffset(double ankle_height);

 private:
  VRObject plate_{"pedal plate frame"};
  Box base_;
  Box tread_;
  std::array<Box, 3> ribs_;
};

/// What the operator sits on: the virtual master. Its frame is the body frame; chair, arm rest and pedals fit
/// the rig.
class OperatorSeat : public VRObject {
 public:
  explicit OperatorSeat(const Rig& rig);

  Joystick& joystick() { return joystick_; }
  Pedal& pedal(bool right) { return right ? pedal_right_ : pedal_left_; }

  /// Half the width and the reach ahead of and behind the origin on the floor, m.
  static double halfWidth(const Rig& rig);
  static double ahead(const Rig& rig);
  static double behind();

 private:
  void buildChair(const Rig& rig);
  void buildArmRest(const Rig& rig);
  void buildPlatform(const Rig& rig);
  void buildPedals(const Rig& rig);

  Loft cushion_;
  Loft back_;
  Box spine_;
  Cylinder column_;
  Box platform_;
  Box trim_;
  Box arm_rest_;
  Loft arm_pad_;
  Box arm_post_;
  Joystick joystick_;
  Pedal pedal_left_{"left pedal"};
  Pedal pedal_right_{"right pedal"};
};

}  // namespace coherency
