#include "common/body/Posture.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "common/math/Rotation.h"

namespace coherency {

namespace {

constexpr double kMinimumSpine = 1e-6;  // m

TransformMatrix headTransform(const MotionSample& s) {
  const YawPitchRoll attitude{s.si(Dof::HeadYaw), s.si(Dof::HeadPitch), s.si(Dof::HeadRoll)};
  TransformMatrix t = rotation(attitude);
  t.setOrigin({s.si(Dof::HeadX), s.si(Dof::HeadY), s.si(Dof::HeadZ)});
  return t;
}

/// The part of `v` normal to the unit vector `along`, as a unit vector; any normal where `v` runs along it.
Coord3 normalPart(const Coord3& v, const Coord3& along) {
  const Coord3 part = v - along * dot(v, along);
  if (norm(part) > 1e-9 * (1.0 + norm(v))) return normalized(part);
  return normalized(cross(along, std::abs(along.x) < 0.5 ? Coord3(1, 0, 0) : Coord3(0, 1, 0)));
}

}  // namespace

Posture posture(const Rig& rig, const ArmKinematics& arm, const MotionSample& sample) {
  Posture p;
  p.t_body_head = headTransform(sample);
  p.hip = {0.0, rig.seat_height, 0.0};
  const Coord3 neck = p.t_body_head.point({0.0, -rig.neck_length, rig.neck_back});
  const Coord3 spine = neck - p.hip;
  const double length = norm(spine);
  p.trunk_stretch = length / rig.trunk_length;
  // A neck in the hips leaves the trunk without direction: it stays upright.
  if (length > kMinimumSpine) p.t_body_thorax = rotationBetween({0.0, 1.0, 0.0}, spine);
  p.t_body_thorax.setOrigin(neck);
  p.t_body_shoulder =
      p.t_body_thorax * TransformMatrix::translation({rig.shoulder_half_width, -rig.shoulder_drop, 0.0});
  p.right_arm = arm.pose(armJoints(sample));
  return p;
}

TransformMatrix headToEye(const Rig& rig, int side) {
  assert(side >= -1 && side <= 1);
  return TransformMatrix::translation({side * rig.eye_distance / 2.0, rig.eye_up, -rig.eye_forward});
}

TransformMatrix frameAlong(const Coord3& from, const Coord3& to, const Coord3& z_hint) {
  const Coord3 span = to - from;
  const Coord3 x = norm(span) > 1e-9 ? normalized(span) : normalPart({0.0, 1.0, 0.0}, normalized(z_hint));
  const Coord3 z = normalPart(z_hint, x);
  return TransformMatrix::fromAxes(x, cross(z, x), z, from);
}

TwoBoneLimb twoBoneLimb(const Coord3& root, const Coord3& tip, double first, double second,
                        const Coord3& pole) {
  assert(first > 0.0 && second > 0.0);
  const Coord3 span = tip - root;
  const double wished = norm(span);
  const double reach = std::clamp(wished, std::abs(first - second), first + second);
  const Coord3 along = wished > 0.0 ? normalized(span) : normalPart(pole, {0.0, 1.0, 0.0});
  // Law of cosines; a limb folded to nothing (equal segments, reach 0) bends square to the span.
  const double forward =
      reach > 0.0 ? (reach * reach + first * first - second * second) / (2.0 * reach) : 0.0;
  const double aside = std::sqrt(std::max(0.0, first * first - forward * forward));
  return {root + along * forward + normalPart(pole, along) * aside, root + along * reach};
}

}  // namespace coherency
