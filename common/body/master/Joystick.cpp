#include "common/body/master/Joystick.h"

#include "common/body/Assemble.h"
#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr double kTilt = 0.35;     // rad at full stick
constexpr double kTwist = 0.45;    // rad at full twist
constexpr double kHandle = 0.105;  // m over the pivot

}  // namespace

Joystick::Joystick() : VRObject("joystick") {
  using enum Loft::Along;
  boot_.setSections(Y, 0.0, {{-0.003, 0.034, 0.034}, {0.036, 0.011, 0.011}}, Ends::Open);
  assemble(*this, boot_, "joystick boot", paint(palette::kSeatFrame));
  addMember(&stick_);
  shaft_.setSections(Y, 0.0, {{0.02, 0.008, 0.008}, {0.05, 0.008, 0.008}}, Ends::Open);
  assemble(stick_, shaft_, "joystick shaft", paint(palette::kMetal, 0.6));
  handle_.setPosition(0.0, kHandle, 0.0);
  stick_.addMember(&handle_);
  grip_.setSections(Y, 0.0, {{-0.058, 0.017, 0.015}, {0.068, 0.020, 0.018}}, Ends::Both);
  assemble(handle_, grip_, "joystick grip", paint(palette::kBelt, 0.3));
  // Ahead of the middle, so that a twist can be seen.
  button_.setSize(0.022, 0.014);
  assemble(handle_, button_, "joystick button", paint(palette::kAccent), {0.0, 0.0688, -0.009});
  button_.setOrientation(TransformMatrix::rotationX(-kTurn / 4));
  set(0.0, 0.0, 0.0);
}

void Joystick::set(double x, double y, double twist) {
  stick_.setOrientation(TransformMatrix::rotationZ(-kTilt * x) * TransformMatrix::rotationX(-kTilt * y));
  handle_.setOrientation(TransformMatrix::rotationY(kTwist * twist));
}

double Joystick::handleHeight() {
  return kHandle;
}

}  // namespace coherency
