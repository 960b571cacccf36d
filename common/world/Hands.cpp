#include "common/world/Hands.h"

#include <algorithm>
#include <cmath>

#include "common/body/Grip.h"
#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr double kGrasp =
    0.050;  // m, farthest centre from the best place that fingers (kUnitHand) close upon

std::uint8_t handBit(Holder which) {
  return which == Holder::OperatorHand ? 1 : 2;
}

/// The place of a movable as seen from a base; exact where the two are near, however far from the origin.
Coord3 fromBase(const Movable& m, const BasePose& base) {
  return {metresFromNanometres(m.x_nm - base.x_nm), metresFromNanometres(m.y_nm - base.y_nm),
          metresFromNanometres(m.z_nm - base.z_nm)};
}

TransformMatrix turnOf(const BasePose& base) {
  return TransformMatrix::rotationY(radiansFromUnits(base.heading_units));
}

}  // namespace

MotionSample scaled(const MotionSample& sample, double scale) {
  if (scale == 1.0) return sample;
  MotionSample mapped = sample;
  for (std::size_t i = 0; i < kDofCount; ++i)
    if (info(dofAt(i)).kind == DofKind::Length)
      mapped.units[i] = static_cast<std::int32_t>(std::clamp(std::round(sample.units[i] * scale), -2e9, 2e9));
  return mapped;
}

TransformMatrix GraspingHand::baseFromHand(const MotionSample& sample) const {
  const Posture p = posture(model_.rig, arm_, scaled(sample, model_.scale));
  return p.t_body_shoulder * p.right_arm.t_shoulder_hand;
}

Coord3 GraspingHand::graspPoint() const {
  return {model_.rig.hand, -kHeldBelow * model_.rig.hand / kUnitHand, 0.0};
}

bool GraspingHand::step(WorldState& state, const MotionSample& sample, const BasePose& base) const {
  const double grip = sample.si(Dof::Grip);
  const bool was_closed = (state.closed_hands & handBit(which_)) != 0;
  if (was_closed ? grip >= kOpensAt : grip < kClosesAt) return false;
  state.closed_hands ^= handBit(which_);
  const TransformMatrix t_base_hand = baseFromHand(sample);
  return was_closed ? letGo(state, t_base_hand, base) : take(state, t_base_hand, base);
}

bool GraspingHand::take(WorldState& state, const TransformMatrix& t_base_hand, const BasePose& base) const {
  // World axes about the base's place.
  const TransformMatrix t_here_hand = turnOf(base) * t_base_hand;
  const Coord3 grasp = t_here_hand.point(graspPoint());
  Movable* nearest = nullptr;
  double least = kGrasp * model_.rig.hand / kUnitHand;
  for (Movable& m : state.movables) {
    const double distance = norm(fromBase(m, base) - grasp);
    if (m.holder != Holder::Nobody || distance > least) continue;
    nearest = &m;
    least = distance;
  }
  if (nearest == nullptr) return false;
  const TransformMatrix t_hand_here = t_here_hand.rigidInverse();
  const Coord3 at = t_hand_here.point(fromBase(*nearest, base));
  setAttitude(*nearest, quaternion(t_hand_here.linear() * rotation(attitude(*nearest))));
  nearest->holder = which_;
  nearest->x_nm = nanometresFromMetres(at.x);
  nearest->y_nm = nanometresFromMetres(at.y);
  nearest->z_nm = nanometresFromMetres(at.z);
  nearest->fall_um = 0;
  nearest->resting = false;
  nearest->unrest_us = 0;
  return true;
}

bool GraspingHand::letGo(WorldState& state, const TransformMatrix& t_base_hand, const BasePose& base) const {
  bool any = false;
  const TransformMatrix t_here_hand = turnOf(base) * t_base_hand;
  for (Movable& m : state.movables) {
    if (m.holder != which_) continue;
    const TransformMatrix t_here_movable = t_here_hand * transform(m);
    const Coord3 at = t_here_movable.origin();
    setAttitude(m, quaternion(t_here_movable));
    m.holder = Holder::Nobody;
    m.x_nm = movedBy(base.x_nm, at.x);
    m.y_nm = movedBy(base.y_nm, at.y);
    m.z_nm = movedBy(base.z_nm, at.z);
    any = true;
  }
  return any;
}

}  // namespace coherency
