#pragma once

#include "common/body/Posture.h"
#include "common/world/WorldModel.h"
#include "common/world/WorldState.h"

namespace coherency {

/// Grip from which on a hand counts as closed, and below which as open again.
inline constexpr double kClosesAt = 0.50;
inline constexpr double kOpensAt = 0.35;

/// The sample as it moves somebody `scale` times the operator's size: angles stay, lengths are multiplied
/// (design: robots of another size are mapped by the rig's scale).
MotionSample scaled(const MotionSample& sample, double scale);

/// A right hand that grasps: what closes around a movable holds it, what opens lets it go.
class GraspingHand {
 public:
  /// `model` outlives this.
  GraspingHand(const VehicleModel& model, Holder which) : model_(model), which_(which), arm_(model.rig) {}

  /// T_base_hand for this sample (not yet scaled).
  TransformMatrix baseFromHand(const MotionSample& sample) const;
  /// Where a movable's centre is when the hand closes upon it best, in the hand's frame, m.
  Coord3 graspPoint() const;

  /// Takes or lets go as the grip says. A hand that closes takes the nearest movable within its grasp that
  /// nobody holds; one that is closed already takes nothing. True if anything changed hands.
  bool step(WorldState& state, const MotionSample& sample, const BasePose& base) const;

 private:
  bool take(WorldState& state, const TransformMatrix& t_base_hand, const BasePose& base) const;
  bool letGo(WorldState& state, const TransformMatrix& t_base_hand, const BasePose& base) const;

  const VehicleModel& model_;
  Holder which_;
  ArmKinematics arm_;
};

}  // namespace coherency
