#include "common/world/Furnishings.h"

#include <cmath>

#include "common/body/Assemble.h"
#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

/// A flat thing in front of the wall: `part` in the plane z.
void assembleFlat(VRObject& owner, Rectangle& part, std::string name, const Material& material, double width,
                  double height, const Coord3& centre) {
  part.setSize(width, height);
  assemble(owner, part, std::move(name), material, centre);
}

std::vector<Coord3> disc(double radius) {
  constexpr int kSides = 24;
  std::vector<Coord3> corners;
  for (int i = 0; i < kSides; ++i) {
    const double angle = kTurn * i / kSides;
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.0});
  }
  return corners;
}

}  // namespace

Block::Block(const std::string& name, std::uint32_t colour) : VRObject(name) {
  assembleBox(*this, cube_, name + " cube", paint(colour, 0.25), {kEdge, kEdge, kEdge},
              {0.0, kEdge / 2, 0.0});
}

Monitor::Monitor() : VRObject("monitor") {
  const Material black = paint(0x26292C, 0.3);
  assembleBox(*this, case_, "monitor case", black, {0.60, 0.36, 0.03}, {0.0, 0.33, 0.0});
  assembleFlat(*this, screen_, "monitor screen", glow(0x24405A), 0.57, 0.33, {0.0, 0.33, 0.0165});
  constexpr std::array<double, 5> kWidths = {0.30, 0.42, 0.36, 0.24, 0.40};
  constexpr std::array<std::uint32_t, 5> kColours = {0xF0C674, 0x9CC3D9, 0xA9C48A, 0x9CC3D9, 0xD98C7A};
  for (std::size_t i = 0; i < lines_.size(); ++i)
    assembleFlat(*this, lines_[i], "monitor line", glow(kColours[i]), kWidths[i], 0.016,
                 {-0.25 + kWidths[i] / 2, 0.43 - 0.045 * static_cast<double>(i), 0.018});
  assembleBox(*this, neck_, "monitor neck", black, {0.06, 0.17, 0.03}, {0.0, 0.09, -0.031});
  assembleBox(*this, foot_, "monitor foot", black, {0.24, 0.012, 0.17}, {0.0, 0.006, 0.0});
  assembleBox(*this, keyboard_, "keyboard", paint(0x3A3E42, 0.1), {0.43, 0.02, 0.14}, {0.0, 0.01, 0.27});
}

DeskLamp::DeskLamp() : VRObject("desk lamp") {
  const Material enamel = paint(palette::kAccent, 0.4);
  foot_.setSize(0.085, 0.02, 16);
  assemble(*this, foot_, "lamp foot", enamel, {0.0, 0.01, 0.0});
  stem_.setSize(0.008, 0.36, 10);
  assemble(*this, stem_, "lamp stem", paint(palette::kMetal, 0.6), {0.0, 0.20, 0.0});
  arm_.setSize(0.008, 0.22, 10);
  assemble(*this, arm_, "lamp arm", paint(palette::kMetal, 0.6), {0.0, 0.415, 0.09});
  arm_.setOrientation(TransformMatrix::rotationX(1.2));
  shade_.setTapered(0.075, 0.03, 0.10, 16);
  assemble(*this, shade_, "lamp shade", enamel, {0.0, 0.42, 0.19});
  bulb_.setSize({0.045, 0.03, 0.045}, 10);
  assemble(*this, bulb_, "lamp bulb", glow(0xFFF1CF), {0.0, 0.372, 0.19});
}

Mug::Mug(std::uint32_t colour) : VRObject("mug") {
  cup_.setTapered(0.036, 0.041, 0.095, 16);
  assemble(*this, cup_, "mug cup", paint(colour, 0.4), {0.0, 0.0475, 0.0});
  coffee_.setSize(0.034, 0.004, 16);
  assemble(*this, coffee_, "mug coffee", paint(0x3B271B, 0.5), {0.0, 0.0945, 0.0});
  assembleBox(*this, handle_, "mug handle", paint(colour, 0.4), {0.03, 0.055, 0.010}, {0.050, 0.05, 0.0});
}

Plant::Plant() : VRObject("plant") {
  pot_.setTapered(0.13, 0.18, 0.34, 18);
  assemble(*this, pot_, "plant pot", paint(0xC9CDC6, 0.2), {0.0, 0.17, 0.0});
  soil_.setSize(0.165, 0.02, 18);
  assemble(*this, soil_, "plant soil", paint(0x4A3A2E), {0.0, 0.335, 0.0});
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    const auto k = static_cast<double>(i);
    const double length = 0.36 + 0.07 * static_cast<double>((i * 5) % 4);
    const double lean = 0.18 + 0.13 * static_cast<double>((i * 3) % 5);
    leaves_[i].setSize({0.055, length, 0.012}, 10);
    const TransformMatrix turn = TransformMatrix::rotationY(2.4 * k) * TransformMatrix::rotationX(lean);
    assemble(*this, leaves_[i], "plant leaf", paint(i % 2 == 0 ? 0x4F7F4A : 0x6A9A5B, 0.2),
             Coord3{0.0, 0.34, 0.0} + turn.vector({0.0, 0.92 * length, 0.0}));
    leaves_[i].setOrientation(turn);
  }
}

Globe::Globe() : VRObject("globe") {
  foot_.setTapered(0.09, 0.03, 0.03, 16);
  assemble(*this, foot_, "globe foot", paint(0x6B4A34, 0.3), {0.0, 0.015, 0.0});
  stem_.setSize(0.010, 0.06, 10);
  assemble(*this, stem_, "globe stem", paint(palette::kMetal, 0.6), {0.0, 0.06, 0.0});
  ball_.setSize({0.13, 0.13, 0.13}, 18);
  assemble(*this, ball_, "globe ball", paint(0x4C86A8, 0.4), {0.0, 0.21, 0.0});
}

Whiteboard::Whiteboard() : VRObject("whiteboard") {
  assembleBox(*this, frame_, "whiteboard frame", paint(palette::kMetal, 0.4), {1.84, 1.14, 0.02},
              {0.0, 0.0, 0.01});
  assembleFlat(*this, surface_, "whiteboard surface", paint(0xF7F7F4, 0.3), 1.78, 1.08, {0.0, 0.0, 0.022});
  struct Stroke {
    double x, y, width, height, turn;
    std::uint32_t colour;
  };
  constexpr std::array<Stroke, 8> kStrokes = {{{-0.55, 0.33, 0.50, 0.016, 0.0, 0x2E5E8C},
                                               {-0.48, 0.25, 0.36, 0.012, 0.0, 0x2E5E8C},
                                               {0.30, -0.30, 0.80, 0.012, 0.0, 0x33383C},
                                               {-0.10, 0.04, 0.012, 0.68, 0.0, 0x33383C},
                                               {0.10, -0.12, 0.44, 0.014, 0.65, 0xB3473C},
                                               {0.46, 0.12, 0.46, 0.014, 0.40, 0xB3473C},
                                               {-0.52, -0.10, 0.42, 0.012, 0.0, 0x4B7F55},
                                               {-0.57, -0.18, 0.32, 0.012, 0.0, 0x4B7F55}}};
  for (std::size_t i = 0; i < strokes_.size(); ++i) {
    const Stroke& s = kStrokes[i];
    assembleFlat(*this, strokes_[i], "whiteboard stroke", paint(s.colour), s.width, s.height,
                 {s.x, s.y, 0.0235 + 0.0005 * static_cast<double>(i)});
    strokes_[i].setOrientation(TransformMatrix::rotationZ(s.turn));
  }
  assembleBox(*this, tray_, "whiteboard tray", paint(palette::kMetal, 0.4), {0.7, 0.015, 0.08},
              {0.0, -0.5775, 0.04});
  assembleBox(*this, pen_, "whiteboard pen", paint(0xB3473C, 0.3), {0.13, 0.018, 0.018}, {0.1, -0.561, 0.05});
}

Poster::Poster() : VRObject("poster") {
  assembleBox(*this, frame_, "poster frame", paint(0x3A3532, 0.2), {0.70, 0.96, 0.02}, {0.0, 0.0, 0.01});
  assembleFlat(*this, paper_, "poster paper", paint(0xEFE7D6), 0.65, 0.91, {0.0, 0.0, 0.022});
  assembleFlat(*this, band_, "poster band", paint(0x2F5D73), 0.65, 0.46, {0.0, 0.135, 0.0235});
  constexpr std::array<double, 4> kX = {-0.12, 0.12, -0.105, 0.135};
  constexpr std::array<double, 4> kRadius = {0.105, 0.105, 0.045, 0.045};
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    discs_[i].setShape(disc(kRadius[i]));
    assemble(*this, discs_[i], "poster disc", paint(i < 2 ? 0xF3E3B8 : 0xC9743A),
             {kX[i], 0.135, i < 2 ? 0.025 : 0.0265});
  }
  constexpr std::array<double, 3> kWidths = {0.46, 0.34, 0.40};
  for (std::size_t i = 0; i < text_.size(); ++i)
    assembleFlat(*this, text_[i], "poster text", paint(0x3A3532), kWidths[i], i == 0 ? 0.040 : 0.016,
                 {0.0, -0.20 - 0.065 * static_cast<double>(i), 0.0235});
}

WallClock::WallClock() : VRObject("wall clock") {
  const TransformMatrix facing = TransformMatrix::rotationX(kTurn / 4);
  rim_.setSize(0.16, 0.03, 28);
  assemble(*this, rim_, "clock rim", paint(0x3A3F43, 0.3), {0.0, 0.0, 0.015});
  rim_.setOrientation(facing);
  dial_.setSize(0.145, 0.006, 28);
  assemble(*this, dial_, "clock dial", paint(0xF7F5EF), {0.0, 0.0, 0.030});
  dial_.setOrientation(facing);
  assembleBox(*this, hands_[0], "clock hour hand", paint(0x26292C), {0.012, 0.08, 0.002},
              {0.028, 0.028, 0.035});
  hands_[0].setOrientation(TransformMatrix::rotationZ(-0.785));
  assembleBox(*this, hands_[1], "clock minute hand", paint(0x26292C), {0.008, 0.12, 0.002},
              {-0.042, 0.042, 0.038});
  hands_[1].setOrientation(TransformMatrix::rotationZ(0.785));
}

}  // namespace coherency
