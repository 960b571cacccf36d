#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "common/body/Posture.h"
#include "common/scene/VRObject.h"
#include "common/scene/ViewPoint.h"

namespace coherency {

enum class Eye : std::uint8_t { Left, Right, Mono };

/// What the virtual human and the slave robot have in common: a posture that follows from a rig and a sample
/// alone, a head with eyes, and a right hand. Its frame is the body frame of Rig.h. Moves.
class PosedBody : public VRObject {
 public:
  const Rig& rig() const { return rig_; }
  const Posture& posture() const { return posture_; }
  const ViewPoint& eye(Eye which) const { return eyes_[static_cast<std::size_t>(which)]; }
  /// The right wrist's frame (ArmKinematics.h), for whatever is attached there; the palm's middle is at x =
  /// Rig::hand.
  VRObject& rightHand() { return right_hand_; }
  const VRObject& rightHand() const { return right_hand_; }

 protected:
  /// Takes up the neutral posture.
  PosedBody(std::string name, const Rig& rig);

  /// Brings posture, head and hand to the sample.
  void takeUp(const MotionSample& sample);
  const ArmKinematics& arm() const { return arm_; }
  VRObject& head() { return head_; }

 private:
  Rig rig_;
  ArmKinematics arm_;
  Posture posture_;
  VRObject head_{"head"};
  VRObject right_hand_{"right hand"};
  std::array<ViewPoint, 3> eyes_;
};

}  // namespace coherency
