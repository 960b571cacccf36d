#include "common/body/master/MasterSeat.h"

#include <algorithm>
#include <cmath>

#include "common/body/Assemble.h"
#include "common/body/Palette.h"
#include "common/scene/Senses.h"

namespace coherency {

namespace {

using enum Loft::Along;

constexpr double kDriveWheel = 0.105;  // m, radii
constexpr double kFrontWheel = 0.050;
constexpr double kRecline = 0.10;  // rad, of the back that nobody leans on
constexpr double kCorner = 0.30;   // of the platform's, cut off

}  // namespace

MasterSeat::MasterSeat(const MasterLayout& layout) : VRObject("master seat") {
  buildPlatform(layout);
  buildWheels(layout);
  buildSeat(layout);
  buildArmRest(layout);
}

void MasterSeat::buildPlatform(const MasterLayout& l) {
  const double half = (l.deck_ahead + l.deck_behind) / 2;
  const double middle = (l.deck_behind - l.deck_ahead) / 2;
  skirt_.setSections(Y, kCorner,
                     {{l.deck_bottom, half, l.deck_half_width, middle},
                      {l.deck_top, half - 0.012, l.deck_half_width - 0.012, middle}},
                     Ends::Open);
  assemble(*this, skirt_, "platform skirt", paint(palette::kAccent, 0.1));
  deck_.setShape(lastRing(skirt_, 8));
  assemble(*this, deck_, "platform deck", paint(palette::kSeatFrame, 0.1));
  deck_.attach(SoundSource{"servo motors hum", 42.0});
}

void MasterSeat::buildWheels(const MasterLayout& l) {
  for (std::size_t i = 0; i < 2; ++i) {
    const double side = i == 0 ? -1.0 : 1.0;
    drive_wheels_[i].setProfile(X, 10, {{-0.018, kDriveWheel}, {0.018, kDriveWheel}},
                                i == 0 ? Ends::Last : Ends::First);
    assemble(*this, drive_wheels_[i], "drive wheel", paint(palette::kWheel),
             {side * (l.deck_half_width + 0.02), kDriveWheel, 0.09});
    hubs_[i].setShape(i == 0 ? firstRing(drive_wheels_[i], 10) : lastRing(drive_wheels_[i], 10));
    assemble(*this, hubs_[i], "hub", paint(palette::kMetal, 0.4), drive_wheels_[i].position());
    front_wheels_[i].setProfile(X, 8, {{-0.012, kFrontWheel}, {0.012, kFrontWheel}}, Ends::Both);
    assemble(*this, front_wheels_[i], "front wheel", paint(palette::kWheel),
             {side * (l.deck_half_width + 0.014), kFrontWheel, 0.30 - l.deck_ahead});
  }
}

void MasterSeat::buildSeat(const MasterLayout& l) {
  const double bottom = l.seat_top - 0.095;
  column_.setProfile(Y, 6, {{l.deck_top, 0.075}, {std::max(bottom, l.deck_top + 0.02), 0.055}}, Ends::Open);
  assemble(*this, column_, "seat column", paint(palette::kMetal, 0.5));
  const double half = l.seat_half_width;
  cushion_.setSections(Y, 0.25, {{bottom, 0.205, half - 0.03, -0.075}, {l.seat_top, 0.230, half, -0.075}},
                       Ends::Both);
  assemble(*this, cushion_, "seat cushion", paint(palette::kSeat));
  cushion_.attach(Surface{"foam", 4e3});
  back_.setSections(Y, 0.0,
                    {{0.03, 0.026, half - 0.05},
                     {0.45 * l.back_height, 0.034, half - 0.01},
                     {l.back_height, 0.024, half - 0.06}},
                    Ends::Both);
  assemble(*this, back_, "seat back", paint(palette::kSeat), {0.0, l.seat_top + 0.068, 0.150});
  back_.setOrientation(TransformMatrix::rotationX(kRecline));
  back_.attach(Surface{"foam", 4e3});
}

void MasterSeat::setPosture(const Posture& posture) {
  const Coord3 spine = posture.t_body_thorax.vector({0.0, 1.0, 0.0});
  const double lean = std::atan2(spine.z, std::max(spine.y, 0.0));  // backwards
  back_.setOrientation(TransformMatrix::rotationX(kRecline + std::max(lean, 0.0)));
}

void MasterSeat::buildArmRest(const MasterLayout& l) {
  const Coord3& stick = l.joystick;
  arm_rest_.setSections(
      Z, 0.0, {{stick.z - 0.045, 0.036, 0.016, 0.0, -0.018}, {0.12, 0.036, 0.022, 0.0, -0.024}}, Ends::Both);
  assemble(*this, arm_rest_, "arm rest", paint(palette::kSeat), {stick.x, stick.y, 0.0});
  const double under = std::max(stick.y - 0.03, l.deck_top + 0.02);
  arm_post_.setSections(Y, 0.0, {{l.deck_top, 0.030, 0.017}, {under, 0.030, 0.017}}, Ends::Open);
  assemble(*this, arm_post_, "arm rest post", paint(palette::kMetal, 0.4), {stick.x, 0.0, 0.02});
}

}  // namespace coherency
