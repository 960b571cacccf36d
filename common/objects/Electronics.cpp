#include "common/objects/Electronics.h"

#include <cmath>

#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"
#include "common/objects/Finish.h"
#include "common/scene/Physical.h"
#include "common/scene/Senses.h"

namespace coherency {

Monitor::Monitor() : VRObject("monitor") {
  const Material black = paint(finish::kBlack, 0.3);
  const Cuboid case_box{{0.60, 0.36, 0.03}, {0.0, 0.33, 0.0}};
  const Cuboid foot{{0.24, 0.012, 0.17}, {0.0, 0.006, 0.0}, kNoBottom};
  const Cuboid keyboard{{0.43, 0.018, 0.14}, {0.0, 0.009, 0.27}, kNoBottom};
  const Cuboid mouse{{0.06, 0.025, 0.10}, {0.31, 0.0125, 0.28}, kNoBottom};
  assembleBoxes(*this, case_, "monitor case", black,
                {case_box, {{0.06, 0.17, 0.03}, {0.0, 0.09, -0.031}}, foot});
  screen_.setSize(0.57, 0.33);
  assemble(*this, screen_, "monitor screen", glow(0x24405A), {0.0, 0.33, 0.0165});
  // What is written on it, in three colours.
  constexpr std::array<std::uint32_t, 3> kColours = {0xF0C674, 0x9CC3D9, 0xA9C48A};
  std::array<Faces, 3> lines;
  for (std::size_t i = 0; i < 9; ++i) {
    const double indent = i % 4 == 0 ? 0.0 : 0.03;
    const double length = 0.14 + 0.05 * static_cast<double>((i * 7) % 5);
    const double y = 0.46 - 0.031 * static_cast<double>(i);
    lines[(i * 5) % 3].addSheet({-0.255 + indent, -0.255 + indent + length, y - 0.006, y + 0.006}, 0.018);
  }
  for (std::size_t c = 0; c < lines.size(); ++c)
    assembleFaces(*this, lines_[c], "monitor lines", glow(kColours[c]), lines[c]);
  assembleBoxes(*this, keyboard_, "keyboard and mouse", paint(0x3A3E42, 0.1), {keyboard, mouse});
  assembleBoxes(*this, keys_, "keyboard keys", paint(0x5A6066, 0.1),
                row({{0.40, 0.004, 0.022}, {0.0, 0.020, 0.225}, kNoBottom}, {0.0, 0.0, 0.029}, 4));
  attach(
      Solids{{{case_box.centre, case_box.size}, {foot.centre, foot.size}, {keyboard.centre, keyboard.size}}});
  attach(finish::plastic());
}

Computer::Computer() : VRObject("computer") {
  constexpr double kDepth = 0.42;
  assembleBoxes(*this, case_, "computer case", paint(0x33383C, 0.2),
                {{{kWidth, kHeight, kDepth}, {0.0, kHeight / 2, 0.0}, kNoBottom}});
  assembleBoxes(*this, front_, "computer front", paint(0x70787D, 0.3),
                row({{0.13, 0.008, 0.006}, {0.0, 0.08, kDepth / 2 + 0.003}, kNoBack}, {0.0, 0.025, 0.0}, 5));
  lamp_.setSize(0.014, 0.014);
  assemble(*this, lamp_, "computer lamp", glow(0x7FD6FF), {0.06, 0.36, kDepth / 2 + 0.0015});
  attach(Solids{{{{0.0, kHeight / 2, 0.0}, {kWidth, kHeight, kDepth}}}});
  attach(finish::steel());
  attach(SoundSource{"a computer's fan hums", 34.0});
}

Oscilloscope::Oscilloscope() : VRObject("oscilloscope") {
  const Cuboid body{{0.40, 0.20, 0.26}, {0.0, 0.115, 0.0}};
  constexpr double kFront = 0.13;
  assembleBoxes(*this, case_, "oscilloscope case", paint(0xC9CEC8, 0.2),
                {body,
                 {{0.30, 0.015, 0.03}, {0.0, 0.0075, 0.09}, kNoTop | kNoBottom},
                 {{0.30, 0.015, 0.03}, {0.0, 0.0075, -0.09}, kNoTop | kNoBottom}});
  screen_.setSize(0.20, 0.15);
  assemble(*this, screen_, "oscilloscope screen", glow(0x12352E), {-0.08, 0.12, kFront + 0.0015});
  Faces wave;
  constexpr int kSteps = 16;
  const auto at = [&](int i, double up) {
    const double x = -0.17 + 0.18 * i / kSteps;
    return Coord3{x, 0.12 + 0.045 * std::sin(2.0 * kTurn * i / kSteps) + up, kFront + 0.003};
  };
  for (int i = 0; i < kSteps; ++i)
    wave.add({at(i, -0.003), at(i + 1, -0.003), at(i + 1, 0.003), at(i, 0.003)});
  assembleFaces(*this, wave_, "oscilloscope wave", glow(0x7CF2B0), wave);
  std::vector<Cuboid> knobs;
  for (const double x : {0.07, 0.14})
    for (const double y : {0.06, 0.11, 0.16})
      knobs.push_back({{0.026, 0.026, 0.016}, {x, y, kFront + 0.008}, kNoBack});
  assembleBoxes(*this, knobs_, "oscilloscope knobs", paint(finish::kSteel, 0.3), knobs);
  attach(Solids{{{{0.0, 0.1075, 0.0}, {0.40, 0.215, 0.26}}}});
  attach(finish::plastic());
}

}  // namespace coherency
