#include "common/objects/ClosedDoors.h"

#include "common/body/Palette.h"
#include "common/objects/Finish.h"
#include "common/objects/Wall.h"
#include "common/scene/Physical.h"

namespace coherency {

namespace {

constexpr double kDeep = -0.05;  // z of the closed leaf

/// An architrave around the opening and a lining into it, down to the leaf.
Faces portal(const Outline& o, double architrave, double proud) {
  const Outline outer = o.inset(-architrave);
  Faces frame;
  frame.addFrame(outer, 0.0, outer, proud);
  frame.addFrame(outer, proud, o.inset(0.012), proud);
  frame.addFrame(o.inset(0.012), proud, o.inset(0.012), kDeep);
  return frame;
}

/// What lies in the opening, on which the leaf stands.
Cuboid sill(const Outline& o) {
  constexpr double kTop = 0.006;
  return {
      {o.width(), kTop, 0.03 - kDeep}, {o.middle(0.0).x, kTop / 2, (0.03 + kDeep) / 2}, kNoBottom | kNoBack};
}

Solids barrier(const Outline& o) {
  return {{{o.middle(-Wall::kThickness / 4), {o.width(), o.height(), Wall::kThickness / 2}}}};
}

}  // namespace

LockedDoor::LockedDoor(const Outline& o) : VRObject("locked door") {
  assembleFaces(*this, frame_, "locked door frame", paint(finish::kTeal, 0.2),
                portal(o, Wall::kArchitrave, 0.018));
  Faces leaf;
  leaf.addSheet(o, kDeep);
  assembleFaces(*this, leaf_, "locked door leaf", paint(0xB9C0BC, 0.15), leaf);
  assembleBoxes(*this, sill_, "locked door sill", paint(finish::kStainless, 0.4), {sill(o)});
  // Slats that let air in, near the floor.
  const double x = (o.left + o.right) / 2;
  assembleBoxes(*this, louvre_, "locked door louvre", paint(0x9BA5A2, 0.15),
                row({{0.44, 0.022, 0.012}, {x, 0.22, kDeep + 0.006}, kNoBack}, {0.0, 0.045, 0.0}, 4));
  const double lock = o.right - 0.09;
  assembleBoxes(*this, rosette_, "locked door rosette", paint(finish::kStainless, 0.5),
                {{{0.05, 0.22, 0.008}, {lock, 0.99, kDeep + 0.004}, kNoBack}});
  assembleBoxes(*this, lever_, "locked door lever", paint(finish::kStainless, 0.7),
                {{{0.016, 0.016, 0.045}, {lock, 1.04, kDeep + 0.0305}, kNoBack},
                 {{0.125, 0.020, 0.014}, {lock - 0.055, 1.04, kDeep + 0.060}},
                 {{0.014, 0.030, 0.006}, {lock, 0.94, kDeep + 0.011}, kNoBack}});
  attach(barrier(o));
  attach(finish::steel());
}

LiftFront::LiftFront(const Outline& o) : VRObject("lift") {
  buildPortal(o);
  buildIndicator(o);
  buildCallPanel(o);
  attach(barrier(o));
  attach(finish::steel());
  attach(SoundSource{"a lift's machine hums in its shaft", 42.0});
}

void LiftFront::buildPortal(const Outline& o) {
  constexpr double kSeam = 0.010;
  constexpr double kBehind = kDeep - 0.008;
  const Material steel = paint(finish::kStainless, 0.6);
  assembleFaces(*this, portal_, "lift portal", steel, portal(o, 0.12, 0.03));
  const double x = (o.left + o.right) / 2;
  const Material leaf = paint(0xA3AAAE, 0.7);
  Faces leaves;
  leaves.addSheet({o.left, x - kSeam / 2, 0.0, o.top}, kDeep);
  leaves.addSheet({x + kSeam / 2, o.right, 0.0, o.top}, kDeep);
  assembleFaces(*this, leaves_, "lift leaves", leaf, leaves);
  Faces seam;  // a little behind them, and wider than the gap between them
  seam.addSheet({x - kSeam, x + kSeam, 0.0, o.top}, kBehind);
  assembleFaces(*this, seam_, "lift seam", paint(finish::kBlack), seam);
  assembleBoxes(*this, sill_, "lift sill", paint(0x8D9497, 0.5), {sill(o)});
}

void LiftFront::buildIndicator(const Outline& o) {
  const double x = (o.left + o.right) / 2;
  const double y = o.top + 0.22;
  assembleBoxes(*this, indicator_, "lift indicator", paint(finish::kBlack, 0.5),
                {{{0.36, 0.12, 0.02}, {x, y, 0.01}, kNoBack}});
  constexpr double kFront = 0.021;
  Faces signs;  // "1", and an arrow upwards
  signs.addSheet({x - 0.075, x - 0.06, y - 0.035, y + 0.035}, kFront);
  signs.add({{x + 0.03, y - 0.02, kFront}, {x + 0.09, y - 0.02, kFront}, {x + 0.06, y + 0.03, kFront}});
  assembleFaces(*this, arrow_, "lift indicator signs", glow(0xFFB347), signs);
}

void LiftFront::buildCallPanel(const Outline& o) {
  const double x = o.right + 0.28;
  const double y = 1.08;
  assembleBoxes(*this, call_panel_, "lift call panel", paint(finish::kStainless, 0.6),
                {{{0.10, 0.24, 0.012}, {x, y, 0.006}, kNoBack}});
  Faces buttons;
  constexpr double kFront = 0.0135;
  buttons.add({{x - 0.025, y + 0.025, kFront}, {x + 0.025, y + 0.025, kFront}, {x, y + 0.065, kFront}});
  buttons.add({{x, y - 0.065, kFront}, {x + 0.025, y - 0.025, kFront}, {x - 0.025, y - 0.025, kFront}});
  assembleFaces(*this, buttons_, "lift buttons", glow(0xFFD9A0), buttons);
}

}  // namespace coherency
