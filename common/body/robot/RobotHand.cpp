#include "common/body/robot/RobotHand.h"

#include "common/body/Assemble.h"
#include "common/body/robot/RobotSize.h"

namespace coherency {

namespace {

using enum Loft::Along;

// Sizes of a hand with kUnitHand from wrist to palm.
constexpr double kHalf = 0.0082;  // m, half a finger's thickness
constexpr std::array<FingerShape, 3> kFingers = {{
    {"index finger", {0.094, 0.0, -0.0250}, -0.10, 1.0, {0.042, 0.026, 0.022}, kHalf},
    {"middle finger", {0.097, 0.0, 0.0}, 0.0, 1.0, {0.044, 0.027, 0.022}, kHalf},
    {"ring finger", {0.094, 0.0, 0.0250}, 0.10, 1.0, {0.042, 0.026, 0.022}, kHalf},
}};
constexpr std::array<double, 2> kThumbLength = {0.040, 0.030};
constexpr Coord3 kThumbRoot{0.046, -0.011, -0.036};

/// A finger's segment along x; the last one ends in a tip.
void buildSegment(Milled& segment, double length, double half, bool last) {
  const double end = last ? 0.70 * half : 0.92 * half;
  segment.setSections(X, 0.0, {{0.1 * length, half, half}, {length, end, end}},
                      last ? Ends::Last : Ends::Open);
}

}  // namespace

RobotHand::RobotHand(double wrist_to_palm) : VRObject("robot hand"), scale_(wrist_to_palm / kUnitHand) {
  buildPalm();
  buildFingers();
  buildThumb();
  setGrip(0.0);
}

void RobotHand::buildPalm() {
  const double s = scale_;
  palm_.setSections(X, 0.40,
                    {{0.010 * s, 0.010 * s, 0.014 * s},
                     {0.036 * s, 0.014 * s, 0.034 * s},
                     {0.074 * s, 0.014 * s, 0.037 * s},
                     {0.092 * s, 0.0055 * s, 0.034 * s, 0.0065 * s}},
                    Ends::Last);
  assemble(*this, palm_, "robot palm", robot_paint::hull());
  cover_.setSections(Y, 0.0, {{0.013 * s, 0.024 * s, 0.022 * s}, {0.019 * s, 0.020 * s, 0.018 * s}},
                     Ends::Last);
  assemble(*this, cover_, "robot hand cover", robot_paint::joint(), {0.062 * s, 0.0, 0.0});
}

void RobotHand::buildFingers() {
  static constexpr const char* kParts[3] = {" proximal", " middle", " distal"};
  const double s = scale_;
  for (std::size_t f = 0; f < fingers_.size(); ++f) {
    const FingerShape& shape = kFingers[f];
    VRObject* root = this;
    for (std::size_t i = 0; i < 3; ++i) {
      const double half = kHalf * s * (1.0 - 0.06 * static_cast<double>(i));
      Milled& segment = fingers_[f][i];
      buildSegment(segment, shape.length[i] * s, half, i == 2);
      const Coord3 at = i == 0 ? shape.knuckle * s : Coord3{shape.length[i - 1] * s, 0.0, 0.0};
      assemble(*root, segment, std::string("robot ") + shape.name + kParts[i],
               i == 2 ? robot_paint::rubber() : robot_paint::hull(), at);
      pins_[f][i].setProfile(Z, 6, {{-1.1 * half, 1.05 * half}, {1.1 * half, 1.05 * half}}, Ends::Both);
      assemble(segment, pins_[f][i], std::string("robot ") + shape.name + " pin", robot_paint::joint());
      root = &segment;
    }
  }
}

void RobotHand::buildThumb() {
  const double s = scale_;
  VRObject* root = this;
  for (std::size_t i = 0; i < 2; ++i) {
    const double half = (i == 0 ? 1.15 : 1.05) * kHalf * s;
    buildSegment(thumb_[i], kThumbLength[i] * s, half, i == 1);
    assemble(*root, thumb_[i], "robot thumb", i == 0 ? robot_paint::hull() : robot_paint::rubber(),
             i == 0 ? kThumbRoot * s : Coord3{kThumbLength[0] * s, 0.0, 0.0});
    thumb_pins_[i].setProfile(Z, 6, {{-1.2 * half, 1.1 * half}, {1.2 * half, 1.1 * half}}, Ends::Both);
    assemble(thumb_[i], thumb_pins_[i], "robot thumb pin", robot_paint::joint());
    root = &thumb_[i];
  }
}

void RobotHand::setGrip(double grip) {
  for (std::size_t f = 0; f < fingers_.size(); ++f)
    bendFinger(fingerBend(kFingers[f], grip), 1.0, {&fingers_[f][0], &fingers_[f][1], &fingers_[f][2]});
  bendThumb(thumbBend(grip), 1.0, thumb_[0], thumb_[1]);
}

}  // namespace coherency
