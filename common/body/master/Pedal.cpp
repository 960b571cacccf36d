#include "common/body/master/Pedal.h"

#include <algorithm>

#include "common/body/Assemble.h"
#include "common/body/Palette.h"

namespace coherency {

namespace {

constexpr double kUp = 0.62;      // rad, released
constexpr double kDown = 0.25;    // rad, pressed
constexpr double kLength = 1.04;  // of the plate, over the foot's
constexpr double kHeel = 0.26;    // from hinge to ankle along the plate, over the foot's length

TransformMatrix plateTilt(double pressed) {
  return TransformMatrix::rotationX(kUp + (kDown - kUp) * std::clamp(pressed, 0.0, 1.0));
}

}  // namespace

Pedal::Pedal(const std::string& name, double foot, double over_deck) : VRObject(name), foot_(foot) {
  using enum Loft::Along;
  block_.setSections(Y, 0.0, {{-over_deck, 0.050, 0.050}, {0.004, 0.024, 0.050}}, Ends::Open);
  assemble(*this, block_, name + " block", paint(palette::kSeatFrame));
  plate_.setName(name + " plate");
  addMember(&plate_);
  tread_.setSections(Z, 0.0,
                     {{0.012 - length(foot), 0.046, 0.004, 0.0, -0.004}, {0.012, 0.052, 0.007, 0.0, -0.007}},
                     Ends::Both);
  assemble(plate_, tread_, name + " tread", paint(palette::kMetal, 0.4));
  set(0.0);
}

void Pedal::set(double pressed) {
  plate_.setOrientation(plateTilt(pressed));
}

TransformMatrix Pedal::foot(double ankle_height) const {
  return transform() * plate_.transform() * TransformMatrix::translation({0.0, ankle_height, -kHeel * foot_});
}

Coord3 Pedal::ankleOffset(double foot, double ankle_height) {
  return plateTilt(0.5).point({0.0, ankle_height, -kHeel * foot});
}

double Pedal::length(double foot) {
  return kLength * foot;
}

}  // namespace coherency
