#pragma once

#include <array>

#include "common/body/Machined.h"
#include "common/body/Posture.h"
#include "common/body/robot/RobotHand.h"

namespace coherency {

/// Right arm of seven joints, each to be seen: drums about the axes of ArmKinematics.h, links between them,
/// and the hand. Body axes.
class RobotArm : public VRObject {
 public:
  explicit RobotArm(const Rig& rig);

  void setPosture(const Posture& posture, double grip);

 private:
  void buildShoulder(double k, double wide);
  void buildUpperArm(const Rig& rig, double k);
  void buildForearm(const Rig& rig, double k);
  void buildWrist(const Rig& rig, double k);

  TransformMatrix base_;  ///< ArmKinematics::base()

  // Frames named as ArmPose names them; hinge frames have z along the elbow's hinge.
  VRObject base_frame_{"robot shoulder base"};
  VRObject flexed_{"robot shoulder"};
  VRObject abducted_{"robot shoulder block"};
  VRObject upper_{"robot upper arm"};
  VRObject upper_hinge_{"robot elbow fork"};
  VRObject bent_{"robot elbow"};
  VRObject bent_hinge_{"robot elbow hinge"};
  VRObject forearm_{"robot forearm"};
  VRObject deviated_{"robot wrist"};

  Turned j1_;
  Arc shoulder_fork_;
  Turned j2_;
  Turned j3_;
  Turned upper_shell_;
  Turned upper_band_;
  std::array<Milled, 2> elbow_cheeks_;
  Turned j4_;
  Turned j5_;
  Turned forearm_shell_;
  Turned forearm_band_;
  std::array<Milled, 2> wrist_cheeks_;
  Turned j7_;
  Turned j6_;
  RobotHand hand_;
};

}  // namespace coherency
