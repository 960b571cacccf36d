#pragma once

#include <array>

#include "common/body/Grip.h"
#include "common/body/Machined.h"

namespace coherency {

/// The robot's right hand: palm, three fingers of three segments and a thumb of two, which close as the
/// human's do (Grip.h). Its frame is the wrist's (ArmKinematics.h).
class RobotHand : public VRObject {
 public:
  /// `wrist_to_palm`: Rig::hand, m; everything scales with it.
  explicit RobotHand(double wrist_to_palm);

  void setGrip(double grip);

 private:
  void buildPalm();
  void buildFingers();
  void buildThumb();

  double scale_;
  Milled palm_;
  Milled cover_;
  std::array<std::array<Milled, 3>, 3> fingers_;
  std::array<std::array<Turned, 3>, 3> pins_;  ///< hinges at the segments' roots
  std::array<Milled, 2> thumb_;
  std::array<Turned, 2> thumb_pins_;
};

}  // namespace coherency
