#include "common/objects/Lamps.h"

#include <cmath>

#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"
#include "common/objects/Finish.h"
#include "common/scene/Light.h"
#include "common/scene/Physical.h"

namespace coherency {

namespace {

constexpr Coord3 kNeutral{1.0, 0.97, 0.92};
constexpr Coord3 kWarm{1.0, 0.90, 0.74};

/// A hollow cone frustum about the y axis, open at the bottom, seen from within and without.
Faces hollowCone(double radius_bottom, double radius_top, double height, int sides) {
  const auto at = [&](double radius, double y, int i) {
    const double angle = kTurn * i / sides;
    return Coord3{radius * std::sin(angle), y, radius * std::cos(angle)};
  };
  Faces cone;
  std::vector<Coord3> lid;
  for (int i = 0; i < sides; ++i) {
    const Coord3 a = at(radius_bottom, 0.0, i);
    const Coord3 b = at(radius_bottom, 0.0, i + 1);
    const Coord3 c = at(radius_top, height, i + 1);
    const Coord3 d = at(radius_top, height, i);
    cone.add({a, b, c, d});
    cone.add({d, c, b, a});
    lid.push_back(d);
  }
  cone.add(lid);
  return cone;
}

}  // namespace

CeilingLamp::CeilingLamp(double width, double depth, double intensity) : VRObject("ceiling lamp") {
  assembleBoxes(*this, frame_, "lamp frame", paint(0xD9D6CF),
                {{{width + 0.05, 0.035, depth + 0.05}, {0.0, -0.0175, 0.0}, kNoTop}});
  assembleBoxes(*this, panel_, "lamp panel", glow(0xFFFDF6),
                {{{width, 0.006, depth}, {0.0, -0.038, 0.0}, kNoTop}});
  attach(Light{{0.0, -0.30, 0.0}, kNeutral, intensity, 8.0});
}

PendantLamp::PendantLamp(double drop, double intensity) : VRObject("pendant lamp") {
  constexpr double kShade = 0.20;
  constexpr double kCord = 0.004;
  rose_.setSize(0.05, 0.03, 14);
  assemble(*this, rose_, "pendant rose", paint(finish::kStainless, 0.4), {0.0, -0.015, 0.0});
  const double top = drop - kShade;
  cord_.setSize(kCord, top, 6);
  assemble(*this, cord_, "pendant cord", paint(finish::kBlack), {0.0, -top / 2, 0.0});
  assembleFaces(*this, shade_, "pendant shade", paint(finish::kTeal, 0.3), hollowCone(0.22, 0.05, kShade, 16),
                {0.0, -drop, 0.0});
  bulb_.setSize({0.055, 0.055, 0.055}, 8);
  assemble(*this, bulb_, "pendant bulb", glow(0xFFF3D6), {0.0, -drop + 0.09, 0.0});
  attach(Light{{0.0, -drop + 0.02, 0.0}, kWarm, intensity, 6.0});
}

StandingLamp::StandingLamp() : VRObject("standing lamp") {
  const Material black = paint(finish::kBlack, 0.3);
  constexpr double kPole = 1.56;
  constexpr double kReach = 0.30;
  foot_.setSize(0.15, 0.025, 20);
  assemble(*this, foot_, "standing lamp foot", black, {0.0, 0.0125, 0.0});
  pole_.setSize(0.012, kPole, 10);
  assemble(*this, pole_, "standing lamp pole", black, {0.0, 0.02 + kPole / 2, 0.0});
  arm_.setSize(0.010, kReach, 10);
  assemble(*this, arm_, "standing lamp arm", black, {0.0, kPole, kReach / 2 - 0.01});
  arm_.setOrientation(TransformMatrix::rotationX(kTurn / 4));
  assembleFaces(*this, shade_, "standing lamp shade", paint(0xE9D9B8, 0.1), hollowCone(0.20, 0.09, 0.20, 16),
                {0.0, kPole - 0.19, kReach});
  bulb_.setSize({0.05, 0.05, 0.05}, 8);
  assemble(*this, bulb_, "standing lamp bulb", glow(0xFFF1CF), {0.0, kPole - 0.12, kReach});
  attach(Light{{0.0, kPole - 0.18, kReach}, kWarm, 0.6, 6.0});
  attach(Solids{{{{0.0, 0.8, 0.0}, {0.24, 1.6, 0.24}}}});
}

DeskLamp::DeskLamp() : VRObject("desk lamp") {
  const Material enamel = paint(finish::kRust, 0.4);
  const Material metal = paint(palette::kMetal, 0.6);
  foot_.setSize(0.085, 0.02, 14);
  assemble(*this, foot_, "desk lamp foot", enamel, {0.0, 0.01, 0.0});
  stem_.setSize(0.008, 0.38, 6);
  assemble(*this, stem_, "desk lamp stem", metal, {0.0, 0.20, 0.0});
  arm_.setSize(0.008, 0.20, 6);
  assemble(*this, arm_, "desk lamp arm", metal, {0.0, 0.42, 0.09});
  arm_.setOrientation(TransformMatrix::rotationX(1.2));
  assembleFaces(*this, shade_, "desk lamp shade", enamel, hollowCone(0.085, 0.03, 0.10, 12),
                {0.0, 0.37, 0.19});
  bulb_.setSize({0.035, 0.035, 0.035}, 8);
  assemble(*this, bulb_, "desk lamp bulb", glow(0xFFF1CF), {0.0, 0.42, 0.19});
  attach(Light{{0.0, 0.378, 0.19}, kWarm, 0.06, 2.5});
  attach(Solids{{{{0.0, 0.20, 0.0}, {0.10, 0.40, 0.10}}, {{0.0, 0.42, 0.15}, {0.16, 0.10, 0.24}}}});
}

}  // namespace coherency
