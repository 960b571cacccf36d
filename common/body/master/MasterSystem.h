#pragma once

#include "common/body/Posture.h"
#include "common/body/master/Exoskeleton.h"
#include "common/body/master/HeadLink.h"
#include "common/body/master/Joystick.h"
#include "common/body/master/MasterLayout.h"
#include "common/body/master/MasterSeat.h"
#include "common/body/master/Pedal.h"

namespace coherency {

/// The tele-existence master that the operator sits on (paper, section IV.A.1): seat on a mobile platform,
/// head mechanism with the head-mounted display, exoskeletal right arm, joystick and two pedals; 336 polygons
/// (section IV.B). All 19 DOFs show on it. Its frame is the body frame, and it fits the rig.
class MasterSystem : public VRObject {
 public:
  explicit MasterSystem(const Rig& rig);

  /// `posture` is that of the same sample.
  void setSample(const Posture& posture, const MotionSample& sample);

  /// The joystick's handle in the body frame; origin at its middle.
  TransformMatrix handle() const;
  const Pedal& pedal(bool right) const { return right ? pedal_right_ : pedal_left_; }
  const Exoskeleton& exoskeleton() const { return exoskeleton_; }

 private:
  MasterLayout layout_;
  MasterSeat seat_;
  Joystick joystick_;
  Pedal pedal_left_;
  Pedal pedal_right_;
  HeadLink head_link_;
  Exoskeleton exoskeleton_;
};

}  // namespace coherency
