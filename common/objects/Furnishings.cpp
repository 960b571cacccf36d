#include "common/objects/Furnishings.h"

#include <cmath>

#include "common/body/Palette.h"
#include "common/math/FixedPoint.h"
#include "common/objects/Finish.h"
#include "common/scene/Light.h"
#include "common/scene/Physical.h"
#include "common/scene/Senses.h"

namespace coherency {

Block::Block(const std::string& name, std::uint32_t colour) : VRObject(name) {
  assembleBox(*this, cube_, name + " cube", paint(colour, 0.25), {kEdge, kEdge, kEdge}, {});
  attach(Graspable{kEdge});
  attach(Moving{});
  attach(finish::wood());
}

Mug::Mug(std::uint32_t colour) : VRObject("mug") {
  cup_.setTapered(0.036, 0.041, 0.095, 12);
  assemble(*this, cup_, "mug cup", paint(colour, 0.4), {0.0, 0.0475, 0.0});
  coffee_.setSize(0.034, 0.004, 12);
  assemble(*this, coffee_, "mug coffee", paint(0x3B271B, 0.5), {0.0, 0.0945, 0.0});
  assembleBox(*this, handle_, "mug handle", paint(colour, 0.4), {0.03, 0.055, 0.010}, {0.050, 0.05, 0.0});
  attach(Solids{{{{0.0, 0.048, 0.0}, {0.08, 0.096, 0.08}}}});
}

Globe::Globe() : VRObject("globe") {
  foot_.setTapered(0.09, 0.03, 0.03, 12);
  assemble(*this, foot_, "globe foot", paint(0x6B4A34, 0.3), {0.0, 0.015, 0.0});
  stem_.setSize(0.010, 0.06, 6);
  assemble(*this, stem_, "globe stem", paint(palette::kMetal, 0.6), {0.0, 0.06, 0.0});
  ball_.setSize({0.13, 0.13, 0.13}, 14);
  assemble(*this, ball_, "globe ball", paint(0x4C86A8, 0.4), {0.0, 0.21, 0.0});
  attach(Solids{{{{0.0, 0.17, 0.0}, {0.24, 0.34, 0.24}}}});
}

ToolBox::ToolBox(std::uint32_t colour) : VRObject("tool box") {
  const Cuboid body{{0.42, 0.17, 0.20}, {0.0, 0.085, 0.0}, kNoBottom};
  assembleBoxes(*this, case_, "tool box case", paint(colour, 0.3), {body});
  assembleBoxes(*this, handle_, "tool box handle", paint(finish::kSteel, 0.4),
                {{{0.20, 0.018, 0.025}, {0.0, 0.215, 0.0}},
                 {{0.015, 0.036, 0.02}, {-0.085, 0.188, 0.0}, kNoTop | kNoBottom},
                 {{0.015, 0.036, 0.02}, {0.085, 0.188, 0.0}, kNoTop | kNoBottom},
                 {{0.05, 0.05, 0.008}, {-0.13, 0.13, 0.104}, kNoBack},
                 {{0.05, 0.05, 0.008}, {0.13, 0.13, 0.104}, kNoBack}});
  attach(Solids{{{body.centre, body.size}}});
  attach(finish::steel());
}

WasteBin::WasteBin() : VRObject("waste bin") {
  bin_.setTapered(0.12, 0.15, 0.32, 16);
  assemble(*this, bin_, "bin wall", paint(0x5E6F78, 0.2), {0.0, 0.16, 0.0});
  inside_.setSize(0.138, 0.004, 16);
  assemble(*this, inside_, "bin inside", paint(0x1E2326), {0.0, 0.3202, 0.0});
  attach(Solids{{{{0.0, 0.16, 0.0}, {0.26, 0.32, 0.26}}}});
  attach(finish::plastic());
}

PaperPile::PaperPile() : VRObject("paper pile") {
  constexpr std::array<std::uint32_t, 3> kCovers = {0x3E6A86, 0xB96A3E, 0x4F7A5A};
  double y = 0.0;
  for (std::size_t i = 0; i < books_.size(); ++i) {
    const double thick = 0.030 - 0.006 * static_cast<double>(i);
    assembleBox(*this, books_[i], "lying book", paint(kCovers[i], 0.05), {0.24, thick, 0.17},
                {0.0, y + thick / 2, 0.0});
    books_[i].setOrientation(TransformMatrix::rotationY(0.25 - 0.3 * static_cast<double>(i)));
    y += thick;
  }
  assembleBox(*this, sheet_, "lying sheet", paint(finish::kPaper), {0.21, 0.003, 0.15},
              {0.0, y + 0.0015, 0.0});
  attach(Solids{{{{0.0, y / 2, 0.0}, {0.22, y, 0.16}}}});
}

}  // namespace coherency
