#pragma once

#include "common/body/Machined.h"
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
  Milled boot_;
  VRObject stick_{"joystick stick"};
  Milled shaft_;
  VRObject handle_{"joystick handle"};
  Milled grip_;
  Rectangle button_;
};

}  // namespace coherency
