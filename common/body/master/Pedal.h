#pragma once

#include <string>

#include "common/body/Machined.h"
#include "common/scene/Primitives.h"

namespace coherency {

/// Pedal hinged at the heel, its origin; -z along the plate. Body axes.
class Pedal : public VRObject {
 public:
  /// Metres. `foot`: length of the foot on it; `over_deck`: the hinge over what it is mounted on.
  Pedal(const std::string& name, double foot, double over_deck);

  void set(double pressed);  ///< 0 released .. 1 down
  /// Ankle of a foot that rests on it, in the pedal's parent's frame, toes along -z of it.
  TransformMatrix foot(double ankle_height) const;
  /// Where that ankle is from the hinge, half pressed.
  static Coord3 ankleOffset(double foot, double ankle_height);
  static double length(double foot);  ///< of the plate, ahead of the hinge, m

 private:
  double foot_;
  VRObject plate_{"pedal plate frame"};
  Milled block_;
  Milled tread_;
};

}  // namespace coherency
