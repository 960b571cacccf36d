#include "common/body/ArmParts.h"

namespace coherency {

void setArm(const Posture& posture, const std::array<VRFrame*, 7>& parts) {
  const ArmPose& arm = posture.right_arm;
  const std::array<const TransformMatrix*, 7> t_shoulder_part = {
      &arm.t_shoulder_flexed,  &arm.t_shoulder_abducted, &arm.t_shoulder_upper, &arm.t_shoulder_bent,
      &arm.t_shoulder_forearm, &arm.t_shoulder_deviated, &arm.t_shoulder_hand};
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i]->setTransform(posture.t_body_shoulder * *t_shoulder_part[i]);
}

}  // namespace coherency
