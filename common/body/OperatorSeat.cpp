#include "common/body/OperatorSeat.h"

#include <algorithm>

#include "common/body/Assemble.h"
#include "common/body/Limbs.h"
#include "common/body/Palette.h"

namespace coherency {

namespace {

constexpr double kTilt = 0.35;       // rad at full stick
constexpr double kTwist = 0.45;      // rad at full twist
constexpr double kHandle = 0.105;    // m over the pivot
constexpr double kPedalUp = 0.62;    // rad, released
constexpr double kPedalDown = 0.25;  // rad, pressed
constexpr double kPedalLength = 0.26;
constexpr double kPlatformTop = 0.05;
constexpr double kHeel = 0.065;  // m from hinge to ankle along the plate

TransformMatrix plateTilt(double pressed) {
  return TransformMatrix::rotationX(kPedalUp + (kPedalDown - kPedalUp) * std::clamp(pressed, 0.0, 1.0));
}

/// Middle of the left hand's grip when the elbow hangs at the side.
Coord3 handleAtRest(const Rig& rig) {
  const double elbow = rig.seat_height + rig.trunk_length - rig.shoulder_drop - rig.upper_arm;
  return {-rig.shoulder_half_width - 0.075, std::max(rig.seat_height + 0.1, elbow + 0.07),
          -rig.forearm - 0.03};
}

Coord3 pivotAtRest(const Rig& rig) {
  return handleAtRest(rig) - Coord3{0.0, kHandle, 0.0};
}

Coord3 pedalHinge(const Rig& rig, double side) {
  const Coord3 ankle = Pedal::ankleOffset(LegShape::ankleHeight(rig));
  const double y = std::max(kPlatformTop + 0.02, rig.seat_height - 0.85 * rig.shin - ankle.y);
  return {side * (rig.hip_half_width + 0.02), y, -(rig.thigh + 0.66 * rig.shin) - ankle.z};
}

}  // namespace

Joystick::Joystick() : VRObject("joystick") {
  boot_.setTapered(0.040, 0.014, 0.05, 14);
  assemble(*this, boot_, "joystick boot", paint(palette::kSeatFrame), {0.0, 0.012, 0.0});
  addMember(&stick_);
  shaft_.setSize(0.009, 0.08, 10);
  assemble(stick_, shaft_, "joystick shaft", paint(palette::kMetal, 0.6), {0.0, 0.04, 0.0});
  handle_.setPosition(0.0, kHandle, 0.0);
  stick_.addMember(&handle_);
  grip_.setSections(
      {{-0.055, 0.020, 0.018}, {-0.020, 0.017, 0.0155}, {0.025, 0.018, 0.016}, {0.060, 0.021, 0.019}},
      {Loft::Along::Y, 12, 2.2, 0.006, 0.014});
  assemble(handle_, grip_, "joystick grip", paint(palette::kBelt, 0.3));
  button_.setSize({0.007, 0.005, 0.007}, 10);
  assemble(handle_, button_, "joystick button", paint(palette::kAccent), {0.0, 0.073, -0.008});
  set(0.0, 0.0, 0.0);
}

void Joystick::set(double x, double y, double twist) {
  stick_.setOrientation(TransformMatrix::rotationZ(-kTilt * x) * TransformMatrix::rotationX(-kTilt * y));
  handle_.setOrientation(TransformMatrix::rotationY(kTwist * twist));
}

double Joystick::handleHeight() {
  return kHandle;
}

Pedal::Pedal(const std::string& name) : VRObject(name) {
  base_.setSize({0.10, 0.03, 0.10});
  assemble(*this, base_, name + " base", paint(palette::kSeatFrame), {0.0, -0.008, 0.0});
  plate_.setName(name + " plate");
  addMember(&plate_);
  tread_.setSize({0.105, 0.014, kPedalLength});
  assemble(plate_, tread_, name + " tread", paint(palette::kMetal, 0.4),
           {0.0, -0.007, -kPedalLength / 2 + 0.01});
  for (std::size_t i = 0; i < ribs_.size(); ++i) {
    ribs_[i].setSize({0.09, 0.004, 0.012});
    assemble(plate_, ribs_[i], name + " rib " + std::to_string(i + 1), paint(palette::kAccent),
             {0.0, 0.0, -0.16 - 0.03 * static_cast<double>(i)});
  }
  set(0.0);
}

void Pedal::set(double pressed) {
  plate_.setOrientation(plateTilt(pressed));
}

TransformMatrix Pedal::foot(double ankle_height) const {
  return transform() * plate_.transform() * TransformMatrix::translation({0.0, ankle_height, -kHeel});
}

Coord3 Pedal::ankleOffset(double ankle_height) {
  return plateTilt(0.5).point({0.0, ankle_height, -kHeel});
}

OperatorSeat::OperatorSeat(const Rig& rig) : VRObject("operator seat") {
  buildChair(rig);
  buildArmRest(rig);
  buildPlatform(rig);
  buildPedals(rig);
}

void OperatorSeat::buildChair(const Rig& rig) {
  const double top = rig.seat_height - 0.075;  // a thigh's half under the hip joints
  const double half = std::max(0.21, rig.hip_half_width + 0.11);
  cushion_.setSections({{top - 0.085, 0.225, half - 0.012, -0.075}, {top - 0.015, 0.232, half, -0.075}},
                       {Loft::Along::Y, 20, 5.0, 0.01, 0.022});
  assemble(*this, cushion_, "seat cushion", paint(palette::kSeat));
  const double back_top = std::max(0.3, 0.86 * rig.trunk_length);
  back_.setSections(
      {{0.04, 0.030, half - 0.04}, {0.5 * back_top, 0.036, half - 0.015}, {back_top, 0.028, half - 0.05}},
      {Loft::Along::Y, 20, 4.0, 0.03, 0.035});
  assemble(*this, back_, "seat back", paint(palette::kSeat), {0.0, rig.seat_height, 0.150});
  back_.setOrientation(TransformMatrix::rotationX(0.10));
  spine_.setSize({0.07, 0.40, 0.035});
  assemble(*this, spine_, "seat spine", paint(palette::kSeatFrame), {0.0, rig.seat_height + 0.05, 0.205});
  spine_.setOrientation(TransformMatrix::rotationX(0.10));
  const double column = std::max(0.02, top - 0.09 - kPlatformTop);
  column_.setTapered(0.085, 0.06, column, 16);
  assemble(*this, column_, "seat column", paint(palette::kMetal, 0.5),
           {0.0, kPlatformTop + column / 2, 0.02});
}

void OperatorSeat::buildArmRest(const Rig& rig) {
  const Coord3 pivot = pivotAtRest(rig);
  const double length = -pivot.z + 0.16;
  const double middle = pivot.z + length / 2 - 0.045;
  arm_rest_.setSize({0.075, 0.045, length});
  assemble(*this, arm_rest_, "arm rest", paint(palette::kSeatFrame), {pivot.x, pivot.y - 0.0345, middle});
  arm_pad_.setSections({{0.0, 0.11, 0.034}, {0.010, 0.112, 0.037}}, {Loft::Along::Y, 16, 4.0, 0.0, 0.008});
  assemble(*this, arm_pad_, "arm rest pad", paint(palette::kSeat), {pivot.x, pivot.y - 0.014, 0.02});
  const double post = std::max(0.02, pivot.y - 0.057 - kPlatformTop);
  arm_post_.setSize({0.045, post, 0.07});
  assemble(*this, arm_post_, "arm rest post", paint(palette::kSeatFrame),
           {pivot.x, kPlatformTop + post / 2, 0.02});
  joystick_.setPosition(pivot);
  addMember(&joystick_);
}

double OperatorSeat::halfWidth(const Rig& rig) {
  return -pivotAtRest(rig).x + 0.05;
}

double OperatorSeat::ahead(const Rig& rig) {
  return -pedalHinge(rig, 1.0).z + kPedalLength + 0.01;
}

double OperatorSeat::behind() {
  return 0.29;
}

void OperatorSeat::buildPlatform(const Rig& rig) {
  const double length = ahead(rig) + behind();
  const double middle = (behind() - ahead(rig)) / 2;
  platform_.setSize({2 * halfWidth(rig), 0.035, length});
  assemble(*this, platform_, "platform", paint(palette::kSeatFrame), {0.0, kPlatformTop - 0.0175, middle});
  trim_.setSize({2 * halfWidth(rig) - 0.04, 0.013, length - 0.04});
  assemble(*this, trim_, "platform skirt", paint(palette::kAccent), {0.0, 0.0085, middle});
}

void OperatorSeat::buildPedals(const Rig& rig) {
  pedal_left_.setPosition(pedalHinge(rig, -1.0));
  pedal_right_.setPosition(pedalHinge(rig, 1.0));
  addMember(&pedal_left_);
  addMember(&pedal_right_);
}

}  // namespace coherency
