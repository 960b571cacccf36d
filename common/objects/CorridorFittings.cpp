#include "common/objects/CorridorFittings.h"

#include <utility>

#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"
#include "common/objects/Finish.h"
#include "common/scene/Physical.h"

namespace coherency {

FireExtinguisher::FireExtinguisher() : VRObject("fire extinguisher") {
  constexpr double kOut = 0.095;  // of the bottle's axis from the wall
  const Material red = paint(finish::kRed, 0.4);
  bottle_.setSize(0.075, 0.42, 14);
  assemble(*this, bottle_, "extinguisher bottle", red, {0.0, -0.05, kOut});
  shoulder_.setSize({0.0745, 0.06, 0.0745}, 14);
  assemble(*this, shoulder_, "extinguisher shoulder", red, {0.0, 0.16, kOut});
  assembleBoxes(*this, valve_, "extinguisher valve", paint(finish::kBlack, 0.3),
                {{{0.035, 0.06, 0.035}, {0.0, 0.24, kOut}, kNoBottom},
                 {{0.022, 0.014, 0.13}, {0.0, 0.272, kOut + 0.055}},
                 {{0.16, 0.02, 0.02}, {0.0, 0.06, 0.012}, kNoBack}});
  assembleBoxes(*this, hose_, "extinguisher hose", paint(0x1F2224),
                {{{0.075, 0.018, 0.018}, {0.053, 0.245, kOut}, kNoLeft},
                 {{0.018, 0.30, 0.018}, {0.099, 0.104, kOut}},
                 {{0.028, 0.10, 0.028}, {0.099, -0.09, kOut}}});
  assembleBoxes(*this, label_, "extinguisher label", paint(finish::kPaper),
                {{{0.06, 0.11, 0.006}, {0.0, -0.05, kOut + 0.074}, kNoBack}});
  constexpr double kSign = 0.50;
  assembleBoxes(*this, sign_, "extinguisher sign", paint(finish::kRed, 0.2),
                {{{0.20, 0.20, 0.004}, {0.0, kSign, 0.002}, kNoBack}});
  Faces mark;  // a bottle and flames, as far as a sign shows them
  mark.addSheet({-0.055, -0.015, kSign - 0.07, kSign + 0.03}, 0.0055);
  mark.addSheet({-0.045, 0.0, kSign + 0.038, kSign + 0.052}, 0.0055);
  mark.add({{0.015, kSign - 0.07, 0.0055}, {0.07, kSign - 0.07, 0.0055}, {0.042, kSign + 0.04, 0.0055}});
  assembleFaces(*this, sign_mark_, "extinguisher sign mark", paint(finish::kPaper), mark);
  attach(Solids{{{{0.0, 0.0, 0.09}, {0.20, 0.52, 0.17}}}});
  attach(finish::steel());
}

ExitSign::ExitSign() : VRObject("exit sign") {
  constexpr double kDrop = 0.22;  // of its middle under the ceiling
  constexpr double kHalf = 0.02;
  assembleBoxes(*this, hangers_, "exit sign hangers", paint(finish::kStainless, 0.4),
                {{{0.012, 0.14, 0.012}, {-0.18, -0.07, 0.0}, kNoTop | kNoBottom},
                 {{0.012, 0.14, 0.012}, {0.18, -0.07, 0.0}, kNoTop | kNoBottom}});
  assembleBoxes(*this, case_, "exit sign case", paint(finish::kStainless, 0.3),
                {{{0.50, 0.18, 2 * kHalf}, {0.0, -kDrop, 0.0}}});
  Faces face;
  face.addSheet({-0.24, 0.24, -kDrop - 0.08, -kDrop + 0.08}, kHalf + 0.0015);
  face.mirror(0.0);
  assembleFaces(*this, faces_of_sign_, "exit sign faces", glow(0x1F9D62), face);
  constexpr double kFront = kHalf + 0.003;
  Faces marks;
  const auto box = [&](double x, double y, double width, double height, double turn) {
    marks.addStroke({x, y - kDrop, kFront}, width, height, turn);
  };
  box(-0.145, 0.0, 0.09, 0.026, 0.0);  // the arrow
  marks.add({{-0.225, -kDrop, kFront}, {-0.18, -kDrop - 0.045, kFront}, {-0.18, -kDrop + 0.045, kFront}});
  box(0.055, 0.052, 0.026, 0.026, 0.0);    // who runs: head,
  box(0.045, 0.012, 0.028, 0.055, -0.25);  // trunk,
  box(0.075, 0.012, 0.050, 0.014, -0.5);   // arms,
  box(0.012, 0.020, 0.040, 0.014, 0.7);
  box(0.020, -0.040, 0.016, 0.060, -0.6);  // legs,
  box(0.072, -0.038, 0.050, 0.016, -0.6);
  box(0.165, 0.0, 0.060, 0.125, 0.0);  // and the door
  marks.mirror(0.0);
  assembleFaces(*this, marks_, "exit sign marks", glow(0xF4FFF8), marks);
}

NamePlate::NamePlate(std::uint32_t colour) : VRObject("name plate") {
  assembleBoxes(*this, plate_, "plate", paint(finish::kPaper, 0.3),
                {{{0.20, 0.15, 0.008}, {0.0, 0.0, 0.004}, kNoBack}});
  constexpr double kFront = 0.0095;
  Faces band;
  band.addSheet({-0.10, 0.10, 0.045, 0.075}, kFront);
  assembleFaces(*this, band_, "plate band", paint(colour), band);
  Faces text;
  text.addSheet({-0.085, 0.03, 0.008, 0.026}, kFront);
  text.addSheet({-0.085, 0.075, -0.022, -0.010}, kFront);
  text.addSheet({-0.085, 0.055, -0.050, -0.038}, kFront);
  assembleFaces(*this, text_, "plate text", paint(0x3A3F43), text);
}

HandRail::HandRail(const std::vector<Stretch>& stretches) : VRObject("hand rail") {
  constexpr double kHigh = 0.90;
  constexpr double kOut = 0.065;
  std::vector<Cuboid> rails;
  std::vector<Cuboid> brackets;
  Solids solids;
  for (const auto& [from, to] : stretches) {
    const double middle = (from + to) / 2;
    rails.push_back({{to - from, 0.05, 0.035}, {middle, kHigh, kOut}});
    solids.boxes.push_back({{middle, kHigh, kOut}, {to - from, 0.05, 0.035}});
    const int count = std::max(2, static_cast<int>((to - from) / 0.9) + 1);
    for (int i = 0; i < count; ++i) {
      const double x = from + 0.12 + (to - from - 0.24) * i / (count - 1);
      brackets.push_back(
          {{0.02, 0.02, kOut - 0.0175}, {x, kHigh - 0.008, (kOut - 0.0175) / 2}, kNoFront | kNoBack});
      brackets.push_back({{0.05, 0.07, 0.006}, {x, kHigh - 0.008, 0.003}, kNoBack});
    }
  }
  assembleBoxes(*this, rail_, "rail", paint(finish::kOak, 0.2), rails);
  assembleBoxes(*this, brackets_, "rail brackets", paint(finish::kStainless, 0.5), brackets);
  attach(std::move(solids));
  attach(finish::wood());
}

}  // namespace coherency
