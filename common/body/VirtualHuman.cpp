#include "common/body/VirtualHuman.h"

#include <algorithm>
#include <array>

#include "common/body/HeadShape.h"
#include "common/body/Limbs.h"
#include "common/body/OperatorSeat.h"
#include "common/body/Trunk.h"

namespace coherency {

namespace {

const Rig& checked(const Rig& rig) {
  validate(rig);
  return rig;
}

/// The left wrist's frame in the joystick handle's: a fist round the handle, thumb up, knuckles to the left.
TransformMatrix wristAtHandle(const Rig& rig) {
  TransformMatrix hand = TransformMatrix::fromAxes({0.0, 0.0, -1.0}, {-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
  hand.setOrigin(-hand.vector({0.93 * rig.hand, -0.030, -0.008}));
  return hand;
}

}  // namespace

/// All that is drawn.
struct VirtualHuman::Shapes {
  explicit Shapes(const Rig& rig)
      : head(rig),
        trunk(rig),
        right_arm(rig, Hand::Side::Right, "right arm"),
        left_arm(rig, Hand::Side::Left, "left arm"),
        legs{LegShape(rig, "left leg"), LegShape(rig, "right leg")},
        seat(rig) {}

  HeadShape head;
  Trunk trunk;
  ArmShape right_arm;
  ArmShape left_arm;
  std::array<LegShape, 2> legs;
  OperatorSeat seat;

  void setRightArm(const Posture& p, double grip);
  void setLeftArm(const Rig& rig, const Posture& p);
  void setLeg(const Rig& rig, const Posture& p, bool right);
};

struct VirtualHuman::Parts {
  explicit Parts(const Rig& r) : rig(checked(r)), arm(r) {}

  Rig rig;
  ArmKinematics arm;
  Posture posture;
  VRObject head{"head"};
  VRObject right_hand{"right hand"};
  std::array<ViewPoint, 3> eyes;
  std::unique_ptr<Shapes> shapes;
};

VirtualHuman::VirtualHuman(const Rig& rig, HumanShown shown)
    : VRObject("virtual human"), parts_(std::make_unique<Parts>(rig)) {
  addMember(&parts_->head);
  addMember(&parts_->right_hand);
  for (const int side : {-1, 1, 0}) {
    const Eye which = side < 0 ? Eye::Left : side > 0 ? Eye::Right : Eye::Mono;
    ViewPoint& eye = parts_->eyes[static_cast<std::size_t>(which)];
    eye.setTransform(headToEye(rig, side));
    eye.attachTo(&parts_->head);
  }
  if (shown == HumanShown::Whole) {
    parts_->shapes = std::make_unique<Shapes>(rig);
    Shapes& s = *parts_->shapes;
    parts_->head.addMember(&s.head);
    for (VRObject* part : std::initializer_list<VRObject*>{&s.trunk, &s.right_arm, &s.left_arm, &s.legs[0],
                                                           &s.legs[1], &s.seat})
      addMember(part);
  }
  MotionSample neutral;
  const auto si = neutralPosture(rig);
  for (std::size_t i = 0; i < kDofCount; ++i) neutral.units[i] = unitsFromSi(info(dofAt(i)).kind, si[i]);
  setSample(neutral);
}

VirtualHuman::~VirtualHuman() = default;

void VirtualHuman::setSample(const MotionSample& sample) {
  Parts& p = *parts_;
  p.posture = coherency::posture(p.rig, p.arm, sample);
  p.head.setTransform(p.posture.t_body_head);
  p.right_hand.setTransform(p.posture.t_body_shoulder * p.posture.right_arm.t_shoulder_hand);
  if (p.shapes == nullptr) return;
  Shapes& s = *p.shapes;
  s.trunk.setPosture(p.posture);
  s.seat.joystick().set(sample.si(Dof::StickX), sample.si(Dof::StickY), sample.si(Dof::StickTwist));
  s.seat.pedal(false).set(sample.si(Dof::PedalLeft));
  s.seat.pedal(true).set(sample.si(Dof::PedalRight));
  s.setRightArm(p.posture, sample.si(Dof::Grip));
  s.setLeftArm(p.rig, p.posture);
  s.setLeg(p.rig, p.posture, false);
  s.setLeg(p.rig, p.posture, true);
}

void VirtualHuman::Shapes::setRightArm(const Posture& p, double grip) {
  right_arm.setPose(p.t_body_shoulder * p.right_arm.t_shoulder_upper,
                    p.t_body_shoulder * p.right_arm.t_shoulder_forearm,
                    p.t_body_shoulder * p.right_arm.t_shoulder_hand);
  right_arm.setGrip(grip);
}

void VirtualHuman::Shapes::setLeftArm(const Rig& rig, const Posture& p) {
  const Coord3 shoulder = p.t_body_thorax.point({-rig.shoulder_half_width, -rig.shoulder_drop, 0.0});
  TransformMatrix hand = seat.transform() * seat.joystick().transform() *
                         seat.joystick().handle().parent()->transform() *
                         seat.joystick().handle().transform() * wristAtHandle(rig);
  const Coord3 outward_down_back{-0.35, -1.0, 0.5};
  const TwoBoneLimb limb =
      twoBoneLimb(shoulder, hand.origin(), rig.upper_arm, rig.forearm, outward_down_back);
  hand.setOrigin(limb.tip_reached);
  const Coord3 up{0.0, 1.0, 0.0};
  left_arm.setPose(frameAlong(shoulder, limb.joint, up), frameAlong(limb.joint, limb.tip_reached, up), hand);
  left_arm.setGrip(0.72);
}

void VirtualHuman::Shapes::setLeg(const Rig& rig, const Posture& p, bool right) {
  const Coord3 hip = p.hip + Coord3{right ? rig.hip_half_width : -rig.hip_half_width, 0.0, 0.0};
  TransformMatrix foot = seat.pedal(right).foot(LegShape::ankleHeight(rig));
  const Coord3 up_ahead{0.0, 1.0, -0.4};
  const TwoBoneLimb limb = twoBoneLimb(hip, foot.origin(), rig.thigh, rig.shin, up_ahead);
  foot.setOrigin(limb.tip_reached);
  legs[right ? 1 : 0].setPose(hip, limb.joint, foot);
}

const Rig& VirtualHuman::rig() const {
  return parts_->rig;
}

const Posture& VirtualHuman::posture() const {
  return parts_->posture;
}

const ViewPoint& VirtualHuman::eye(Eye which) const {
  return parts_->eyes[static_cast<std::size_t>(which)];
}

VRObject& VirtualHuman::rightHand() {
  return parts_->right_hand;
}

}  // namespace coherency
