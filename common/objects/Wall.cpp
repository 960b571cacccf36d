#include "common/objects/Wall.h"

#include <algorithm>
#include <utility>

#include "common/body/Palette.h"
#include "common/objects/Finish.h"
#include "common/scene/Physical.h"

namespace coherency {

namespace {

constexpr double kSkirtingHeight = 0.09;

/// The stretches of a wall between the openings that begin at the floor, each `beside` wider than it is, from
/// left to right.
std::vector<std::pair<double, double>> stretches(const Wall::Form& form, double inset, double beside) {
  std::vector<std::pair<double, double>> all;
  double from = -form.width / 2 + inset;
  std::vector<Outline> openings = form.openings;
  std::sort(openings.begin(), openings.end(), [](const auto& a, const auto& b) { return a.left < b.left; });
  for (const Outline& o : openings) {
    if (o.bottom > 0.0) continue;
    all.emplace_back(from, o.left - beside);
    from = o.right + beside;
  }
  all.emplace_back(from, form.width / 2 - inset);
  return all;
}

/// Half as thick as a wall between rooms is: the other half is the next room's.
Solids solidsOf(const Wall::Form& form) {
  constexpr double kThick = Wall::kThickness / 2;
  Solids solids;
  for (const auto& [from, to] : stretches(form, 0.0, 0.0))
    solids.boxes.push_back(
        {{(from + to) / 2, form.height / 2, -kThick / 2}, {to - from, form.height, kThick}});
  return solids;
}

}  // namespace

Wall::Wall(const Form& form, std::string name) : VRObject(std::move(name)) {
  buildSurface(form);
  buildSkirting(form);
  attach(solidsOf(form));
  attach(finish::plaster());
}

void Wall::buildSurface(const Form& form) {
  const double half = form.width / 2;
  Faces surface;
  surface.addSheet({-half, half, form.dado, form.height}, 0.0, form.openings);
  for (const Outline& opening : form.openings)
    surface.addFrame(opening, 0.0, opening, opening.bottom > 0.0 ? -kOuterThickness : -kThickness / 2);
  assembleFaces(*this, surface_, name() + " surface", paint(form.colour), surface);
  if (form.dado <= 0.0) return;
  Faces dado;
  dado.addSheet({-half, half, 0.0, form.dado}, 0.0, form.openings);
  assembleFaces(*this, dado_, name() + " dado", paint(form.dado_colour, 0.1), dado);
}

void Wall::buildSkirting(const Form& form) {
  std::vector<Cuboid> boards;
  for (const auto& [from, to] : stretches(form, form.skirting_inset, kArchitrave))
    boards.push_back({{to - from, kSkirtingHeight, kSkirtingDepth},
                      {(from + to) / 2, kSkirtingHeight / 2, kSkirtingDepth / 2},
                      kNoBack | kNoBottom});
  assembleBoxes(*this, skirting_, name() + " skirting", paint(0x8C7A66, 0.1), boards);
}

Wall::Form plainWall(std::uint32_t colour, std::vector<Outline> openings) {
  Wall::Form form{};
  form.colour = colour;
  form.openings = std::move(openings);
  return form;
}

Facade::Facade(double left, double right, const std::vector<Outline>& openings, bool corner)
    : VRObject("facade") {
  constexpr double kPlinthTop = 0.02;
  constexpr double kTop = 3.3;
  Faces surface;
  surface.addSheet({left, right, kPlinthTop, kTop}, 0.0, openings);
  assembleFaces(*this, surface_, "facade surface", finish::daylit(0xE4D9C4), surface);
  const auto board = [&](double from, double to, double depth, unsigned hidden) {
    const double begin = corner ? left + depth : left;
    return Cuboid{
        {right - begin, to - from, depth}, {(begin + right) / 2, (from + to) / 2, depth / 2}, hidden};
  };
  assembleBoxes(*this, plinth_, "facade plinth", finish::daylit(0x9A938A),
                {board(kGround, kPlinthTop, 0.03, kNoBack | kNoBottom)});
  assembleBoxes(*this, cornice_, "facade cornice", finish::daylit(0xF0EADF),
                {board(kTop - 0.14, kTop, 0.07, kNoBack)});
}

Outline fromBehind(const Outline& opening) {
  return {-opening.right, -opening.left, opening.bottom, opening.top};
}

}  // namespace coherency
