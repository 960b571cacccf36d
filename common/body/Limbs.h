#pragma once

#include "common/body/Hand.h"
#include "common/body/Loft.h"
#include "common/body/Rig.h"

namespace coherency {

/// Upper arm, forearm and hand; each segment's x axis runs along it from its joint (ArmKinematics.h). Its own
/// frame is the body frame.
class ArmShape : public VRObject {
 public:
  ArmShape(const Rig& rig, Hand::Side side, const std::string& name);

  void setPose(const TransformMatrix& t_body_upper, const TransformMatrix& t_body_forearm,
               const TransformMatrix& t_body_hand);
  void setGrip(double grip) { hand_.setGrip(grip); }

 private:
  Loft upper_;
  Loft forearm_;
  Loft sleeve_;
  Loft cuff_;
  Hand hand_;
};

/// Thigh, shin and a shoe; segments run along x from their joints, the shoe's frame has its origin at the
/// ankle, y up and -z to the toes. Its own frame is the body frame.
class LegShape : public VRObject {
 public:
  LegShape(const Rig& rig, const std::string& name);

  static double ankleHeight(const Rig& rig);  ///< ankle over the sole, m

  void setPose(const Coord3& hip, const Coord3& knee, const TransformMatrix& t_body_foot);

 private:
  void buildShoe(const Rig& rig);

  VRObject foot_;
  Loft thigh_;
  Loft shin_;
  Loft shoe_;
  Loft sole_;
};

}  // namespace coherency
