#include "common/objects/Laboratory.h"

#include "common/objects/Finish.h"

namespace coherency {

namespace {

constexpr double kHalfX = Laboratory::kWidth / 2;
constexpr double kHalfZ = Laboratory::kDepth / 2;

constexpr std::array<Outline, 3> kWindows = {
    {{-3.00, -1.80, 0.95, 2.35}, {-1.65, -0.45, 0.95, 2.35}, {-0.30, 0.90, 0.95, 2.35}}};
constexpr Outline kDoor = Door::opening(0.10);

Shell::Form shell() {
  return {Laboratory::kWidth,
          Laboratory::kDepth,
          Laboratory::kHeight,
          plainWall(finish::kSage, {kWindows.begin(), kWindows.end()}),
          plainWall(finish::kWarmWhite),
          plainWall(finish::kWarmWhite),
          plainWall(finish::kWarmWhite, {kDoor})};
}

std::vector<Outline> windowsFromOutside() {
  std::vector<Outline> all;
  all.reserve(kWindows.size());
  for (const Outline& window : kWindows) all.push_back(fromBehind(window));
  return all;
}

}  // namespace

Laboratory::Laboratory()
    : VRObject("laboratory"),
      floor_(kWidth, kDepth, 0.5, 0xC2B49F, 0xB1A28C, 0.12),
      shell_(shell()),
      facade_(-kHalfX + 0.08, kHalfX + Wall::kOuterThickness, windowsFromOutside(), true),
      windows_{Window(kWindows[0]), Window(kWindows[1]), Window(kWindows[2])},
      sills_{WindowSill(kWindows[0]), WindowSill(kWindows[1]), WindowSill(kWindows[2])},
      radiators_{Radiator(1.1), Radiator(1.1)},
      door_(kDoor),
      lamps_{CeilingLamp(1.2, 0.5, 2.0), CeilingLamp(1.2, 0.5, 2.0), CeilingLamp(1.2, 0.5, 2.0),
             CeilingLamp(1.2, 0.5, 2.0)},
      chair_(0x4E6472),
      mug_(0xE9E3D6),
      tool_boxes_{ToolBox(finish::kRed), ToolBox(0x3E6A86)},
      back_poster_(0x4B6350),
      small_plant_(0.5) {
  attach(finish::ambient());
  buildShell();
  furnishFront();
  furnishDesk();
  furnishBack();
  furnishRight();
}

void Laboratory::buildShell() {
  put(*this, floor_, {});
  put(*this, shell_, {});
  put(*this, facade_, {0.0, 0.0, -kHalfZ - Wall::kOuterThickness}, kFacesFront);
  for (std::size_t i = 0; i < windows_.size(); ++i) {
    put(shell_.front(), windows_[i], {});
    put(shell_.front(), sills_[i], {});
  }
  put(shell_.right(), door_, {});
  for (std::size_t i = 0; i < lamps_.size(); ++i)
    put(*this, lamps_[i], {i % 2 == 0 ? -1.5 : 1.5, kHeight, i / 2 == 0 ? -1.3 : 1.3});
}

void Laboratory::furnishFront() {
  put(shell_.front(), radiators_[0], {-1.05, 0.0, 0.0});
  put(shell_.front(), radiators_[1], {0.30, 0.0, 0.0});
  put(shell_.front(), poster_, {1.5, 1.6, 0.0});
  put(*this, bookshelf_, {2.72, 0.0, -kHalfZ + Bookshelf::kDepth / 2 + 0.02});
  put(*this, plant_, {-kHalfX + 0.5, 0.0, -kHalfZ + 0.5});
}

void Laboratory::furnishDesk() {
  put(*this, desk_, {-kHalfX + 0.37, 0.0, -0.9}, kFacesRight);
  put(desk_, monitor_, {0.0, Desk::kHeight, -0.15});
  put(desk_, desk_lamp_, {0.58, Desk::kHeight, -0.18});
  put(desk_, mug_, {-0.42, Desk::kHeight, 0.05});
  put(desk_, computer_, {-0.50, 0.0, -0.02});
  put(*this, chair_, {-kHalfX + 0.98, 0.0, -0.85}, kFacesLeft + 0.3);
  put(*this, bin_, {-kHalfX + 0.25, 0.0, 0.15});
  put(shell_.left(), whiteboard_, {-0.95, 1.62, 0.0});
}

void Laboratory::furnishBack() {
  put(*this, workbench_, {-0.9, 0.0, kHalfZ - Workbench::kDepth / 2 - 0.02}, kFacesFront);
  put(workbench_, oscilloscopes_[0], {0.55, Workbench::kHeight, -0.06}, 0.1);
  put(workbench_, oscilloscopes_[1], {0.06, Workbench::kHeight, -0.08}, -0.1);
  put(workbench_, tool_boxes_[0], {-0.80, Workbench::kHeight, -0.10});
  put(workbench_, tool_boxes_[1], {0.70, Workbench::kShelf, -0.22});
  put(workbench_, papers_, {-0.30, Workbench::kShelf, -0.21});
  put(*this, rack_, {1.10, 0.0, kHalfZ - Rack::kDepth / 2 - 0.05}, kFacesFront);
  put(shell_.back(), vent_, {-1.1, 2.45, 0.0});
  put(shell_.back(), back_poster_, {-2.45, 1.6, 0.0});
}

void Laboratory::furnishRight() {
  put(*this, cabinet_, {kHalfX - Cabinet::kDepth / 2 - 0.02, 0.0, -1.35}, kFacesLeft);
  put(cabinet_, globe_, {-0.32, Cabinet::kHeight, 0.0});
  put(cabinet_, small_plant_, {0.33, Cabinet::kHeight, 0.0});
  put(shell_.right(), clock_, {-0.70, 2.15, 0.0});
}

}  // namespace coherency
