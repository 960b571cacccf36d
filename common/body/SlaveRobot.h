#pragma once

#include <memory>

#include "common/body/PosedBody.h"

namespace coherency {

/// The slave robot (paper, section IV.B): head with two cameras, trunk, right arm of seven joints with a
/// hand, on a base with wheels; 834 polygons. Its frame is a body frame (Rig.h) on the floor under it. Its
/// joints are the operator's, its measures those of a rig of its own (robotRig()).
class SlaveRobot : public PosedBody {
 public:
  explicit SlaveRobot(const Rig& robot_rig);
  ~SlaveRobot() override;

  /// Takes up the posture of a sample in the robot's own measures (scaled(), common/world/Hands.h).
  void setSample(const MotionSample& sample);

 private:
  struct Shapes;
  std::unique_ptr<Shapes> shapes_;
};

}  // namespace coherency
