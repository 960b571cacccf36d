#pragma once

#include <cstdint>
#include <memory>

#include "common/body/Posture.h"
#include "common/scene/ViewPoint.h"

namespace coherency {

enum class Eye : std::uint8_t { Left, Right, Mono };

/// What a scene requires of the operator's copy: all of it, or its eyes and frames alone, nothing drawn.
enum class HumanShown : std::uint8_t { Whole, None };

/// The operator's copy in the virtual world, sitting on the master (paper, sections I and II): head, trunk,
/// right arm with a gripping hand, left hand on the joystick, feet on the pedals, legs; seat, joystick and
/// pedals with them. Its frame is the body frame of Rig.h. Every DOF shows: the stick tilts and twists, the
/// pedals turn, the fingers close. The head is there for others to see; how it keeps out of the own eyes'
/// view stands in HeadShape.h.
class VirtualHuman : public VRObject {
 public:
  /// Throws std::domain_error where the rig is not valid.
  explicit VirtualHuman(const Rig& rig, HumanShown shown = HumanShown::Whole);
  ~VirtualHuman() override;

  /// Rebuilds every part from the sample (never from the last posture).
  void setSample(const MotionSample& sample);

  const Rig& rig() const;
  const Posture& posture() const;
  const ViewPoint& eye(Eye which) const;
  /// The right wrist's frame (ArmKinematics.h), for whatever is attached there; the palm's middle is at x =
  /// Rig::hand.
  VRObject& rightHand();

 private:
  struct Parts;
  struct Shapes;
  std::unique_ptr<Parts> parts_;
};

}  // namespace coherency
