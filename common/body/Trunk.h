#pragma once

#include "common/body/Loft.h"
#include "common/body/Posture.h"
#include "common/body/Rig.h"

namespace coherency {

/// Chest, belly and shoulders in the thorax frame, which stretches between hips and neck as the operator
/// does, and the pelvis, which keeps to the seat. Sizes follow the rig's trunk and shoulders.
class Trunk : public VRObject {
 public:
  explicit Trunk(const Rig& rig);

  /// Where the posture has it; this object's own frame is the body frame.
  void setPosture(const Posture& posture);

 private:
  void buildChest(const Rig& rig);
  void buildPelvis(const Rig& rig);

  VRObject thorax_{"thorax"};
  Loft chest_;
  Loft collar_;
  Loft neck_base_;
  Loft pelvis_;
  Loft belt_;
};

}  // namespace coherency
