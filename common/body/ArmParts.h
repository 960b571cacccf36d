#pragma once

#include <array>

#include "common/body/Posture.h"
#include "common/scene/VRFrame.h"

namespace coherency {

/// Sets what an arm's parts hang on, from the shoulder outwards: flexed, abducted, upper arm, bent elbow,
/// forearm, deviated wrist, hand (ArmPose), each in the body frame.
void setArm(const Posture& posture, const std::array<VRFrame*, 7>& parts);

}  // namespace coherency
