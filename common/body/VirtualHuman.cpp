#include "common/body/VirtualHuman.h"

#include <array>

#include "common/body/HeadShape.h"
#include "common/body/Limbs.h"
#include "common/body/Trunk.h"
#include "common/body/master/MasterSystem.h"

namespace coherency {

namespace {

constexpr double kOnStick = 0.87;  // grip of the left hand

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
        master(rig) {}

  HeadShape head;
  Trunk trunk;
  ArmShape right_arm;
  ArmShape left_arm;
  std::array<LegShape, 2> legs;
  MasterSystem master;

  void setRightArm(const Posture& p, double grip);
  void setLeftArm(const Rig& rig, const Posture& p);
  void setLeg(const Rig& rig, const Posture& p, bool right);
};

VirtualHuman::VirtualHuman(const Rig& rig, HumanShown shown) : PosedBody("virtual human", checked(rig)) {
  if (shown == HumanShown::Whole) {
    shapes_ = std::make_unique<Shapes>(rig);
    Shapes& s = *shapes_;
    head().addMember(&s.head);
    for (VRObject* part : std::initializer_list<VRObject*>{&s.trunk, &s.right_arm, &s.left_arm, &s.legs[0],
                                                           &s.legs[1], &s.master})
      addMember(part);
  }
  setSample(neutralSample(rig));
}

VirtualHuman::~VirtualHuman() = default;

void VirtualHuman::setSample(const MotionSample& sample) {
  takeUp(sample);
  if (shapes_ == nullptr) return;
  Shapes& s = *shapes_;
  s.master.setSample(posture(), sample);
  s.trunk.setPosture(posture());
  s.setRightArm(posture(), sample.si(Dof::Grip));
  s.setLeftArm(rig(), posture());
  s.setLeg(rig(), posture(), false);
  s.setLeg(rig(), posture(), true);
}

const MasterSystem* VirtualHuman::master() const {
  return shapes_ == nullptr ? nullptr : &shapes_->master;
}

void VirtualHuman::Shapes::setRightArm(const Posture& p, double grip) {
  right_arm.setPose(p.t_body_shoulder * p.right_arm.t_shoulder_upper,
                    p.t_body_shoulder * p.right_arm.t_shoulder_forearm,
                    p.t_body_shoulder * p.right_arm.t_shoulder_hand);
  right_arm.setGrip(grip);
}

void VirtualHuman::Shapes::setLeftArm(const Rig& rig, const Posture& p) {
  const Coord3 shoulder = p.t_body_thorax.point({-rig.shoulder_half_width, -rig.shoulder_drop, 0.0});
  TransformMatrix hand = master.handle() * wristAtHandle(rig);
  const Coord3 outward_down_back{-0.35, -1.0, 0.5};
  const TwoBoneLimb limb =
      twoBoneLimb(shoulder, hand.origin(), rig.upper_arm, rig.forearm, outward_down_back);
  hand.setOrigin(limb.tip_reached);
  const Coord3 up{0.0, 1.0, 0.0};
  left_arm.setPose(frameAlong(shoulder, limb.joint, up), frameAlong(limb.joint, limb.tip_reached, up), hand);
  left_arm.setGrip(kOnStick);
}

void VirtualHuman::Shapes::setLeg(const Rig& rig, const Posture& p, bool right) {
  const Coord3 hip = p.hip + Coord3{right ? rig.hip_half_width : -rig.hip_half_width, 0.0, 0.0};
  TransformMatrix foot = master.pedal(right).foot(LegShape::ankleHeight(rig));
  const Coord3 up_ahead{0.0, 1.0, -0.4};
  const TwoBoneLimb limb = twoBoneLimb(hip, foot.origin(), rig.thigh, rig.shin, up_ahead);
  foot.setOrigin(limb.tip_reached);
  legs[right ? 1 : 0].setPose(hip, limb.joint, foot);
}

}  // namespace coherency
