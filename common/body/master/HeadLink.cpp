#include "common/body/master/HeadLink.h"

#include <algorithm>
#include <numbers>

#include "common/body/Assemble.h"
#include "common/body/HeadShape.h"
#include "common/body/Palette.h"

namespace coherency {

namespace {

using enum Loft::Along;

constexpr double kApart = 0.017;  // m, half the distance of a member's two bars
constexpr double kMember = 0.30;  // m at the least

}  // namespace

HeadLink::HeadLink(const Rig& rig, const MasterLayout& layout)
    : VRObject("head link"), root_(layout.mast_top) {
  wrist_ = {0.0, 0.01, 0.160 * headScale(rig)};
  const Coord3 rest = neutralHead(rig) + wrist_;
  member_ = std::max(kMember, 0.75 * norm(rest - root_));
  buildMast(layout);
  buildLinkage();
  buildHeadset(rig);
}

void HeadLink::buildMast(const MasterLayout& l) {
  const double top = root_.y;
  mast_.setSections(Y, 0.0, {{l.deck_top, 0.020, 0.034}, {top, 0.014, 0.024}}, Ends::Open);
  assemble(*this, mast_, "mast", paint(palette::kMetal, 0.4), {0.0, 0.0, root_.z});
  const double height = l.seat_top + 0.068 + 0.55 * l.back_height;
  seat_bracket_.setSections(Z, 0.0, {{0.19, 0.060, 0.024}, {root_.z - 0.015, 0.020, 0.024}}, Ends::Open);
  assemble(*this, seat_bracket_, "seat bracket", paint(palette::kSeatFrame), {0.0, height, 0.0});
}

/// Members along x, the drums' axes along z.
void HeadLink::buildLinkage() {
  addMember(&lower_);
  addMember(&upper_);
  for (std::size_t i = 0; i < 2; ++i) {
    const double aside = i == 0 ? -kApart : kApart;
    lower_bars_[i].setBar(member_, 0.007, 0.010, Ends::Open);
    assemble(lower_, lower_bars_[i], "head link bar", paint(palette::kMetal, 0.5), {0.0, aside, 0.0});
    upper_bars_[i].setBar(member_, 0.006, 0.009, Ends::Open);
    assemble(upper_, upper_bars_[i], "head link bar", paint(palette::kMetal, 0.5), {0.0, 0.8 * aside, 0.0});
  }
  root_drum_.setProfile(Z, 6, {{-0.026, 0.034}, {0.026, 0.034}}, Ends::Both);
  assemble(lower_, root_drum_, "head link root", paint(palette::kSeatFrame, 0.2));
  elbow_drum_.setProfile(Z, 6, {{-0.020, 0.029}, {0.020, 0.029}}, Ends::Both);
  assemble(upper_, elbow_drum_, "head link elbow", paint(palette::kAccent, 0.2));
}

void HeadLink::buildHeadset(const Rig& rig) {
  const double k = headScale(rig);
  const Material shell = paint(palette::kHeadset, 0.35);
  const Material frame = paint(palette::kSeatFrame, 0.2);
  addMember(&pan_);
  yoke_.setSections(Y, 0.0, {{-0.028, 0.014, 0.022}, {0.028, 0.014, 0.022}}, Ends::Both);
  assemble(pan_, yoke_, "head link yoke", frame);
  addMember(&headset_);
  stem_.setSections(Z, 0.0, {{0.11 * k, 0.012, 0.012}, {wrist_.z - 0.008, 0.012, 0.012}}, Ends::Open);
  assemble(headset_, stem_, "head link stem", paint(palette::kMetal, 0.5), {0.0, wrist_.y, 0.0});
  plate_.setSections(Z, 0.0, {{0.080 * k, 0.089 * k, 0.022}, {0.125 * k, 0.040 * k, 0.018}}, Ends::Last);
  assemble(headset_, plate_, "headset plate", shell, {0.0, wrist_.y, 0.0});
  for (std::size_t i = 0; i < 2; ++i) {
    const double side = i == 0 ? -1.0 : 1.0;
    bands_[i].setSections(
        Z, 0.0, {{-0.07 * k, 0.004, 0.011, 0.0, rig.eye_up}, {0.10 * k, 0.004, 0.011, 0.0, wrist_.y}},
        Ends::Open);
    assemble(headset_, bands_[i], "headset band", frame, {side * 0.0865 * k, 0.0, 0.0});
  }
  // Wide enough for the eyes, and closed in front only: its back lies in the face.
  visor_.setSections(Z, 0.30,
                     {{-0.158 * k, 0.064 * k, 0.030 * k, 0.0, rig.eye_up},
                      {-0.130 * k, 0.090 * k, 0.046 * k, 0.0, rig.eye_up},
                      {-0.050 * k, 0.072 * k, 0.044 * k, 0.0, rig.eye_up}},
                     Ends::First);
  assemble(headset_, visor_, "headset display", shell);
}

void HeadLink::setPosture(const Posture& posture) {
  const TransformMatrix& head = posture.t_body_head;
  const Coord3 wrist = head.point(wrist_);
  const Coord3 back_and_up{0.0, 1.0, 0.7};
  // A head farther away than the members reach stretches them: it stays connected.
  const double stretch = std::max(1.0, norm(wrist - root_) / (1.98 * member_));
  const double length = stretch * member_;
  const TwoBoneLimb limb = twoBoneLimb(root_, wrist, length, length, back_and_up);
  const Coord3 side{1.0, 0.0, 0.0};
  lower_.setTransform(frameAlong(root_, limb.joint, side));
  upper_.setTransform(frameAlong(limb.joint, limb.tip_reached, side));
  for (const auto& bars : {&lower_bars_, &upper_bars_})
    for (Milled& bar : *bars) bar.setOrientation(TransformMatrix::scaling({stretch, 1.0, 1.0}));
  TransformMatrix pan = rotation(YawPitchRoll{yawPitchRoll(head.linear()).yaw, 0.0, 0.0});
  pan.setOrigin(wrist);
  pan_.setTransform(pan);
  headset_.setTransform(head);
}

}  // namespace coherency
