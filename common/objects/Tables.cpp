#include "common/objects/Tables.h"

#include <utility>

#include "common/body/Palette.h"
#include "common/objects/Finish.h"
#include "common/scene/Physical.h"

namespace coherency {

namespace {

/// What is drawn of these boxes, and stops and carries: the same.
void add(Solids& solids, const std::vector<Cuboid>& boxes) {
  for (const Cuboid& box : boxes) solids.boxes.push_back({box.centre, box.size});
}

/// Four upright boxes at the corners of a rectangle width x depth.
std::vector<Cuboid> corners(double width, double depth, double thick, double height) {
  std::vector<Cuboid> legs;
  for (const double x : {-0.5, 0.5})
    for (const double z : {-0.5, 0.5})
      legs.push_back({{thick, height, thick}, {x * width, height / 2, z * depth}, kNoBottom | kNoTop});
  return legs;
}

}  // namespace

Table::Table() : VRObject("table") {
  constexpr double kTop = 0.028;
  const std::vector<Cuboid> top = {{{kWidth, kTop, kDepth}, {0.0, kHeight - kTop / 2, 0.0}}};
  const std::vector<Cuboid> legs = corners(kWidth - 0.14, kDepth - 0.14, 0.045, kHeight - kTop - 0.03);
  assembleBoxes(*this, top_, "table top", paint(finish::kPaleOak, 0.12), top);
  assembleBoxes(*this, frame_, "table frame", paint(finish::kSteel, 0.3),
                {{{kWidth - 0.08, 0.03, kDepth - 0.08}, {0.0, kHeight - kTop - 0.015, 0.0}, kNoTop}});
  assembleBoxes(*this, apron_, "table apron", paint(finish::kOak, 0.1),
                {{{kWidth - 0.16, 0.22, 0.018}, {0.0, kHeight - kTop - 0.14, -kDepth / 2 + 0.07}, kNoTop}});
  assembleBoxes(*this, legs_, "table legs", paint(finish::kSteel, 0.3), legs);
  Solids solids{{{{0.0, kHeight - 0.03, 0.0}, {kWidth, 0.06, kDepth}}}};  // top and frame
  add(solids, legs);
  attach(std::move(solids));
  attach(finish::wood());
}

Desk::Desk() : VRObject("desk") {
  constexpr double kTop = 0.03;
  constexpr double kUnder = kHeight - kTop;
  constexpr double kBlock = 0.51;  // x of the drawer block's middle
  const std::vector<Cuboid> top = {{{kWidth, kTop, kDepth}, {0.0, kHeight - kTop / 2, 0.0}}};
  const std::vector<Cuboid> body = {
      {{0.03, kUnder, 0.62}, {-0.70, kUnder / 2, 0.0}, kNoBottom | kNoTop},
      {{0.985, 0.35, 0.02}, {-0.1925, kUnder - 0.175, -0.28}, kNoTop | kNoLeft | kNoRight},
      {{0.42, kUnder, 0.60}, {kBlock, kUnder / 2, 0.0}, kNoBottom | kNoTop}};
  assembleBoxes(*this, top_, "desk top", paint(finish::kOak, 0.15), top);
  assembleBoxes(*this, body_, "desk body", paint(finish::kLaminate), body);
  std::vector<Cuboid> fronts;
  std::vector<Cuboid> grips;
  for (const double y : {0.58, 0.37, 0.16}) {
    fronts.push_back({{0.39, 0.19, 0.016}, {kBlock, y, 0.308}, kNoBack});
    grips.push_back({{0.12, 0.014, 0.02}, {kBlock, y + 0.05, 0.326}, kNoBack});
  }
  assembleBoxes(*this, fronts_, "desk drawer fronts", paint(0xF2EFE8, 0.1), fronts);
  assembleBoxes(*this, grips_, "desk drawer grips", paint(finish::kSteel, 0.4), grips);
  Solids solids;
  add(solids, top);
  add(solids, body);
  attach(std::move(solids));
  attach(finish::wood());
}

MeetingTable::MeetingTable() : VRObject("meeting table") {
  constexpr double kTop = 0.025;
  constexpr double kEdge = 0.04;
  constexpr double kUnder = kHeight - kTop - kEdge;
  const std::vector<Cuboid> top = {{{kWidth, kTop, kDepth}, {0.0, kHeight - kTop / 2, 0.0}}};
  std::vector<Cuboid> columns;
  for (const double x : {-0.95, 0.95}) {
    columns.push_back({{0.10, kUnder - 0.04, 0.52}, {x, (kUnder + 0.04) / 2, 0.0}, kNoBottom | kNoTop});
    columns.push_back({{0.14, 0.04, 0.86}, {x, 0.02, 0.0}, kNoBottom});
  }
  assembleBoxes(*this, top_, "meeting table top", paint(finish::kPaleOak, 0.2), top);
  assembleBoxes(*this, edge_, "meeting table edge", paint(finish::kWalnut, 0.1),
                {{{kWidth - 0.05, kEdge, kDepth - 0.05}, {0.0, kHeight - kTop - kEdge / 2, 0.0}, kNoTop}});
  assembleBoxes(*this, columns_, "meeting table columns", paint(finish::kSteel, 0.3), columns);
  Solids solids{{{{0.0, kHeight - (kTop + kEdge) / 2, 0.0}, {kWidth, kTop + kEdge, kDepth}}}};
  add(solids, columns);
  attach(std::move(solids));
  attach(finish::wood());
}

Workbench::Workbench() : VRObject("workbench") {
  constexpr double kTop = 0.04;
  constexpr double kLeg = 0.05;
  constexpr double kBoard = 0.025;
  constexpr double kBack = -kDepth / 2 + 0.02;
  const std::vector<Cuboid> top = {{{kWidth, kTop, kDepth}, {0.0, kHeight - kTop / 2, 0.0}}};
  const std::vector<Cuboid> legs = corners(kWidth - 0.12, kDepth - 0.10, kLeg, kHeight - kTop);
  const std::vector<Cuboid> shelves = {
      {{kWidth - 0.20, kBoard, kDepth - 0.20}, {0.0, 0.20, 0.0}},
      {{kWidth, kBoard, 0.28}, {0.0, kShelf - kBoard / 2, -kDepth / 2 + 0.14}}};
  std::vector<Cuboid> frame = legs;
  for (const double x : {-1.0, 0.0, 1.0})  // what carries the upper shelf
    frame.push_back({{0.04, kShelf - kBoard - kHeight, 0.03},
                     {x * (kWidth / 2 - 0.06), (kShelf - kBoard + kHeight) / 2, kBack},
                     kNoBottom | kNoTop});
  assembleBoxes(*this, top_, "workbench top", paint(finish::kOak, 0.15), top);
  assembleBoxes(*this, frame_, "workbench frame", paint(finish::kTeal, 0.2), frame);
  assembleBoxes(*this, shelves_, "workbench shelves", paint(finish::kPaleOak, 0.1), shelves);
  Solids solids;
  add(solids, top);
  add(solids, legs);
  add(solids, shelves);
  attach(std::move(solids));
  attach(finish::wood());
}

}  // namespace coherency
