#pragma once

#include <array>

#include "common/body/Machined.h"
#include "common/body/Posture.h"
#include "common/body/master/MasterLayout.h"

namespace coherency {

/// The master's exoskeletal right arm: links beside upper arm, forearm and hand, joined by the seven axes of
/// ArmKinematics.h, and a lever on the fingers that measures the grip. It hangs on a telescopic carrier from
/// the seat and follows the shoulder. Body axes.
class Exoskeleton : public VRObject {
 public:
  Exoskeleton(const Rig& rig, const MasterLayout& layout);

  /// `knuckle_bend`: of the fingers at their roots, rad.
  void setPosture(const Posture& posture, double knuckle_bend);

 private:
  void buildCarrier(const MasterLayout& layout);
  void buildShoulder();
  void buildElbow(const Rig& rig);
  void buildForearm(const Rig& rig);
  void buildWrist();
  void buildHand(const Rig& rig);
  void setCarrier(const TransformMatrix& t_body_shoulder);

  TransformMatrix base_;  ///< ArmKinematics::base()
  Coord3 root_;           ///< of the carrier
  double girth_;          ///< of the arm; what goes around it keeps its distance by this

  // Frames named as ArmPose names them.
  VRObject carrier_{"exoskeleton carrier"};
  VRObject flexed_{"exoskeleton shoulder"};
  VRObject abducted_{"exoskeleton shoulder ring"};
  VRObject upper_{"exoskeleton upper arm"};
  VRObject upper_hinge_{"exoskeleton upper arm side"};  ///< z along the elbow's hinge
  VRObject bent_{"exoskeleton elbow"};
  VRObject bent_hinge_{"exoskeleton elbow side"};
  VRObject forearm_{"exoskeleton forearm"};
  VRObject deviated_{"exoskeleton wrist"};
  VRObject hand_{"exoskeleton hand"};
  VRObject lever_{"exoskeleton finger lever"};

  Milled bracket_;
  Milled sleeve_;
  Milled rod_;
  std::array<Turned, 5> drums_;  ///< of j1, j2, j4, j7 and j6
  Arc shoulder_link_;            ///< from j1 to j2
  Milled hanger_;                ///< from j2 to the ring
  Arc shoulder_ring_;            ///< j3
  Milled upper_bar_;
  Milled elbow_bar_;
  Arc forearm_ring_;  ///< j5
  Milled forearm_bar_;
  Arc wrist_link_;  ///< from j7 to j6
  Milled hand_bar_;
  Milled hand_plate_;
  Milled finger_bar_;
};

}  // namespace coherency
