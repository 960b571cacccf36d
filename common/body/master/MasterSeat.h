#pragma once

#include <array>

#include "common/body/Machined.h"
#include "common/body/Posture.h"
#include "common/body/master/MasterLayout.h"
#include "common/scene/Polygon.h"

namespace coherency {

/// What the operator sits on: mobile platform with four wheels, seat, and arm rest for the left arm. Body
/// axes. Its motors hum, its cushion yields (common/scene/Senses.h).
class MasterSeat : public VRObject {
 public:
  explicit MasterSeat(const MasterLayout& layout);
  /// The back gives way to who leans on it.
  void setPosture(const Posture& posture);

 private:
  void buildPlatform(const MasterLayout& layout);
  void buildWheels(const MasterLayout& layout);
  void buildSeat(const MasterLayout& layout);
  void buildArmRest(const MasterLayout& layout);

  Milled skirt_;
  Polygon deck_;
  std::array<Turned, 2> drive_wheels_;
  std::array<Polygon, 2> hubs_;
  std::array<Turned, 2> front_wheels_;
  Turned column_;
  Milled cushion_;
  Milled back_;
  Milled arm_rest_;
  Milled arm_post_;
};

}  // namespace coherency
