#include "common/body/master/Exoskeleton.h"

#include <algorithm>

#include "common/body/ArmParts.h"
#include "common/body/Assemble.h"
#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

using enum Loft::Along;

constexpr double kRight = kTurn / 4;
constexpr double kRingFromShoulder = 0.135;  // m along the upper arm, of a girth of 1
constexpr double kSleeve = 0.16;

const Material& link() {
  static const Material material = paint(palette::kLink, 0.45);
  return material;
}
const Material& drum() {
  static const Material material = paint(palette::kSeatFrame, 0.2);
  return material;
}
const Material& accent() {
  static const Material material = paint(palette::kAccent, 0.2);
  return material;
}

}  // namespace

Exoskeleton::Exoskeleton(const Rig& rig, const MasterLayout& layout)
    : VRObject("exoskeleton"),
      base_(ArmKinematics(rig).base()),
      root_(layout.exoskeleton),
      girth_(std::clamp(armGirth(rig), 0.6, 1.15)) {
  for (VRObject* frame : {&carrier_, &flexed_, &abducted_, &upper_, &bent_, &forearm_, &deviated_, &hand_})
    addMember(frame);
  upper_.addMember(&upper_hinge_);
  upper_hinge_.setTransform(ArmKinematics::hingeFrame());
  bent_.addMember(&bent_hinge_);
  bent_hinge_.setTransform(ArmKinematics::hingeFrame());
  hand_.addMember(&lever_);
  buildCarrier(layout);
  buildShoulder();
  buildElbow(rig);
  buildForearm(rig);
  buildWrist();
  buildHand(rig);
}

void Exoskeleton::buildCarrier(const MasterLayout& layout) {
  const Coord3 from{layout.mast_top.x + 0.015, root_.y, layout.mast_top.z};
  bracket_.setBar(norm(root_ - from) + 0.03, 0.020, 0.020, Ends::Last);
  assemble(*this, bracket_, "exoskeleton bracket", paint(palette::kMetal, 0.4));
  bracket_.setTransform(frameAlong(from, root_, {0.0, 0.0, 1.0}));
  sleeve_.setBar(kSleeve, 0.015, 0.015, Ends::Last);
  assemble(carrier_, sleeve_, "exoskeleton sleeve", drum());
  rod_.setBar(1.0, 0.009, 0.009, Ends::Open);
  assemble(carrier_, rod_, "exoskeleton rod", link());
}

void Exoskeleton::buildShoulder() {
  const double g = girth_;
  drums_[0].setProfile(X, 6, {{0.092 * g, 0.030}, {0.126 * g, 0.030}}, Ends::Both);
  assemble(flexed_, drums_[0], "exoskeleton j1", drum());
  shoulder_link_.setForm(Y, {0.104 * g, 0.116 * g, 0.016, kRight, 2 * kRight, 2}, Ends::Open);
  assemble(flexed_, shoulder_link_, "exoskeleton shoulder link", link());
  drums_[1].setProfile(Z, 6, {{-0.126 * g, 0.026}, {-0.094 * g, 0.026}}, Ends::Both);
  assemble(abducted_, drums_[1], "exoskeleton j2", drum());
  const double ring = kRingFromShoulder * g;
  hanger_.setSections(Y, 0.0, {{-ring, 0.004, 0.014, -0.0855 * g}, {0.0, 0.006, 0.014, -0.110 * g}},
                      Ends::Open);
  assemble(abducted_, hanger_, "exoskeleton hanger", link());
  shoulder_ring_.setForm(Y, {0.080 * g, 0.091 * g, 0.013, kRight - 2.1, kRight + 2.1, 4}, Ends::Both);
  assemble(abducted_, shoulder_ring_, "exoskeleton j3", link(), {0.0, -ring, 0.0});
}

void Exoskeleton::buildElbow(const Rig& rig) {
  const double g = girth_;
  const double ring = kRingFromShoulder * g;
  const double out = 0.097 * g;
  upper_bar_.setSections(
      X, 0.0, {{ring - 0.019, 0.026, 0.007, 0.0, out}, {rig.upper_arm, 0.013, 0.006, 0.0, out}}, Ends::First);
  assemble(upper_hinge_, upper_bar_, "exoskeleton upper arm bar", link());
  drums_[2].setProfile(Z, 6, {{0.062 * g, 0.030}, {0.110 * g, 0.030}}, Ends::Both);
  assemble(bent_hinge_, drums_[2], "exoskeleton j4", drum());
}

void Exoskeleton::buildForearm(const Rig& rig) {
  const double g = girth_;
  const double at = 0.46 * rig.forearm;
  elbow_bar_.setSections(X, 0.0, {{0.0, 0.012, 0.006, 0.0, 0.078 * g}, {at, 0.010, 0.004, 0.0, 0.065 * g}},
                         Ends::Open);
  assemble(bent_hinge_, elbow_bar_, "exoskeleton elbow bar", link());
  forearm_ring_.setForm(X, {0.060 * g, 0.070 * g, 0.012, -1.9, 1.9, 3}, Ends::Both);
  assemble(bent_, forearm_ring_, "exoskeleton j5", link(), {at, 0.0, 0.0});
  forearm_bar_.setSections(
      X, 0.0, {{at - 0.018, 0.006, 0.016, 0.074 * g}, {rig.forearm, 0.005, 0.008, 0.046 * g}}, Ends::First);
  assemble(forearm_, forearm_bar_, "exoskeleton forearm bar", link());
}

void Exoskeleton::buildWrist() {
  const double g = girth_;
  drums_[3].setProfile(Y, 6, {{0.034 * g, 0.018}, {0.060 * g, 0.018}}, Ends::Both);
  assemble(deviated_, drums_[3], "exoskeleton j7", drum());
  wrist_link_.setForm(X, {0.044 * g, 0.053 * g, 0.010, 0.0, kRight, 1}, Ends::Open);
  assemble(deviated_, wrist_link_, "exoskeleton wrist link", link());
  drums_[4].setProfile(Z, 6, {{0.036 * g, 0.016}, {0.060 * g, 0.016}}, Ends::Both);
  assemble(hand_, drums_[4], "exoskeleton j6", drum());
}

/// Along the little finger's side and over the back of the hand: the palm and what it grasps stay free.
void Exoskeleton::buildHand(const Rig& rig) {
  const double s = rig.hand / 0.09;
  hand_bar_.setSections(
      X, 0.0, {{0.0, 0.009, 0.005, 0.0, 0.052 * s}, {0.082 * s, 0.008, 0.005, 0.017 * s, 0.052 * s}},
      Ends::Last);
  assemble(hand_, hand_bar_, "exoskeleton hand bar", link());
  hand_plate_.setSections(Z, 0.0,
                          {{-0.020 * s, 0.009 * s, 0.003, 0.075 * s, 0.024 * s},
                           {0.050 * s, 0.007 * s, 0.003, 0.075 * s, 0.024 * s}},
                          Ends::First);
  assemble(hand_, hand_plate_, "exoskeleton hand plate", link());
  lever_.setPosition(0.098 * s, 0.002 * s, -0.0105 * s);
  finger_bar_.setSections(
      X, 0.0, {{-0.018 * s, 0.003, 0.008 * s, 0.0165 * s}, {0.038 * s, 0.003, 0.006 * s, 0.0115 * s}},
      Ends::Both);
  assemble(lever_, finger_bar_, "exoskeleton finger bar", accent());
}

void Exoskeleton::setPosture(const Posture& posture, double knuckle_bend) {
  setCarrier(posture.t_body_shoulder);
  setArm(posture, {&flexed_, &abducted_, &upper_, &bent_, &forearm_, &deviated_, &hand_});
  lever_.setOrientation(TransformMatrix::rotationZ(-knuckle_bend));
}

/// The rod is pulled out as far as the shoulder is away.
void Exoskeleton::setCarrier(const TransformMatrix& t_body_shoulder) {
  const Coord3 mount = t_body_shoulder.point(base_.vector({0.118 * girth_, 0.0, 0.0}));
  carrier_.setTransform(frameAlong(root_, mount, {0.0, 0.0, 1.0}));
  const double length = std::max(0.01, norm(mount - root_));
  rod_.setOrientation(TransformMatrix::scaling({length, 1.0, 1.0}));
}

}  // namespace coherency
