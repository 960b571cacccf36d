#include "common/objects/WallFittings.h"

#include <cmath>

#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"
#include "common/objects/Finish.h"
#include "common/scene/Physical.h"
#include "common/scene/Senses.h"

namespace coherency {

WallClock::WallClock() : VRObject("wall clock") {
  const TransformMatrix facing = TransformMatrix::rotationX(kTurn / 4);
  rim_.setSize(0.16, 0.03, 24);
  assemble(*this, rim_, "clock rim", paint(0x3A3F43, 0.3), {0.0, 0.0, 0.015});
  rim_.setOrientation(facing);
  dial_.setSize(0.145, 0.006, 24);
  assemble(*this, dial_, "clock dial", paint(0xF7F5EF), {0.0, 0.0, 0.030});
  dial_.setOrientation(facing);
  Faces marks;
  for (int hour = 0; hour < 12; ++hour) {
    const double angle = kTurn * hour / 12;
    marks.addStroke({0.122 * std::sin(angle), 0.122 * std::cos(angle), 0.0345}, hour % 3 == 0 ? 0.012 : 0.006,
                    0.024, -angle);
  }
  assembleFaces(*this, marks_, "clock marks", paint(finish::kBlack), marks);
  const auto hand = [this](std::size_t i, double width, double length, double turn, double z) {
    assembleBox(*this, hands_[i], i == 0 ? "clock hour hand" : "clock minute hand", paint(finish::kBlack),
                {width, length, 0.002},
                Coord3{std::sin(turn), std::cos(turn), 0.0} * (0.5 * length) + Coord3{0, 0, z});
    hands_[i].setOrientation(TransformMatrix::rotationZ(-turn));
  };
  hand(0, 0.012, 0.08, kTurn * (9.0 + 1.0 / 6.0) / 12.0, 0.0365);
  hand(1, 0.008, 0.12, kTurn * 10.0 / 60.0, 0.0395);
  attach(SoundSource{"a wall clock ticks", 30.0});
}

Radiator::Radiator(double width) : VRObject("radiator") {
  constexpr double kFin = 0.080;
  constexpr double kGap = 0.024;
  constexpr double kHeight = 0.55;
  constexpr double kMiddle = 0.13 + kHeight / 2;
  const int fins = static_cast<int>(width / (kFin + kGap));
  const Cuboid first{
      {kFin, kHeight, 0.07}, {-(fins - 1) / 2.0 * (kFin + kGap), kMiddle, 0.075}, kNoBack | kNoBottom};
  const std::vector<Cuboid> boxes = row(first, {kFin + kGap, 0.0, 0.0}, fins);
  assembleBoxes(*this, fins_, "radiator fins", paint(0xECE9E1, 0.2), boxes);
  assembleBoxes(*this, pipes_, "radiator pipes", paint(0xDAD6CC, 0.2),
                {{{width, 0.03, 0.03}, {0.0, kMiddle + 0.22, 0.075}, kNoBack},
                 {{width, 0.03, 0.03}, {0.0, kMiddle - 0.22, 0.075}, kNoBack},
                 {{0.025, 0.16, 0.025}, {-width / 2 + 0.04, 0.08, 0.075}, kNoTop | kNoBottom}});
  attach(Solids{{{{0.0, kMiddle / 2 + kHeight / 4, 0.055}, {width, kMiddle + kHeight / 2, 0.11}}}});
  attach(finish::steel());
}

AirVent::AirVent() : VRObject("air vent") {
  const Outline hole = Outline::centred(0.50, 0.20);
  assembleFaces(*this, frame_, "air vent frame", paint(0xDCD9D2, 0.2), pictureFrame(hole, 0.025, 0.012));
  assembleSheet(*this, dark_, "air vent duct", paint(0x2A2E31), hole, 0.002);
  const Cuboid slat{{0.50, 0.016, 0.006}, {0.0, -0.072, 0.007}, kNoLeft | kNoRight | kNoBack};
  assembleBoxes(*this, slats_, "air vent slats", paint(0xDCD9D2, 0.2), row(slat, {0.0, 0.036, 0.0}, 5));
  attach(SoundSource{"air rushes through a grille", 36.0});
}

}  // namespace coherency
