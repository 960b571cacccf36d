#include "common/objects/Office.h"

#include "common/objects/Finish.h"

namespace coherency {

namespace {

constexpr double kHalfX = Office::kWidth / 2;
constexpr double kHalfZ = Office::kDepth / 2;

constexpr std::array<Outline, 2> kWindows = {{{-2.05, -0.35, 0.90, 2.20}, {0.35, 2.05, 0.90, 2.20}}};
constexpr Outline kDoor = Door::opening(-1.35);  // in the left wall, whose x is -z

Shell::Form shell() {
  return {Office::kWidth,
          Office::kDepth,
          Office::kHeight,
          plainWall(finish::kWarmWhite),
          plainWall(0xC9A27C),
          plainWall(finish::kWarmWhite, {kDoor}),
          plainWall(finish::kWarmWhite, {kWindows.begin(), kWindows.end()})};
}

}  // namespace

Office::Office()
    : VRObject("office"),
      floor_(kWidth, kDepth, 0.763, 0x7F8C95, 0x76838C),
      shell_(shell()),
      windows_{Window(kWindows[0]), Window(kWindows[1])},
      sills_{WindowSill(kWindows[0]), WindowSill(kWindows[1])},
      radiator_(1.4),
      door_(kDoor),
      lamps_{CeilingLamp(1.2, 0.3, 2.6), CeilingLamp(1.2, 0.3, 2.6)},
      chairs_{SwivelChair(0x4E6472), SwivelChair(finish::kRust)},
      mugs_{Mug(finish::kRust), Mug(0x4E8A8B)},
      poster_(0x6B4C58),
      armchair_(0x52707A),
      plant_(1.0) {
  attach(finish::ambient());
  buildShell();
  furnishDesks();
  furnishWalls();
  furnishCorner();
}

void Office::buildShell() {
  put(*this, floor_, {});
  put(*this, shell_, {});
  for (std::size_t i = 0; i < windows_.size(); ++i) {
    put(shell_.right(), windows_[i], {});
    put(shell_.right(), sills_[i], {});
  }
  put(shell_.right(), radiator_, {-1.20, 0.0, 0.0});
  put(shell_.left(), door_, {});
  for (std::size_t i = 0; i < lamps_.size(); ++i)
    put(*this, lamps_[i], {0.0, kHeight, i == 0 ? -1.25 : 1.25});
}

/// One at the front wall, one under the window.
void Office::furnishDesks() {
  put(*this, desks_[0], {0.85, 0.0, -kHalfZ + Desk::kDepth / 2 + 0.03});
  put(*this, desks_[1], {kHalfX - Desk::kDepth / 2 - 0.08, 0.0, 1.05}, kFacesLeft);
  for (std::size_t i = 0; i < desks_.size(); ++i) {
    put(desks_[i], monitors_[i], {-0.05, Desk::kHeight, -0.14});
    put(desks_[i], mugs_[i], {0.38, Desk::kHeight, 0.12});
    put(desks_[i], computers_[i], {-0.52, 0.0, -0.02});
  }
  put(desks_[0], desk_lamp_, {0.60, Desk::kHeight, -0.20});
  put(desks_[1], papers_, {-0.54, Desk::kHeight, 0.05});
  put(*this, chairs_[0], {0.80, 0.0, -1.50}, kFacesFront - 0.25);
  put(*this, chairs_[1], {1.22, 0.0, 1.00}, kFacesRight + 0.35);
  put(*this, bin_, {1.85, 0.0, -2.25});
}

void Office::furnishWalls() {
  put(*this, bookshelf_, {-1.20, 0.0, -kHalfZ + Bookshelf::kDepth / 2 + 0.02});
  put(shell_.front(), notice_board_, {0.85, 1.60, 0.0});
  put(*this, cabinet_, {-0.75, 0.0, kHalfZ - Cabinet::kDepth / 2 - 0.02}, kFacesFront);
  put(cabinet_, globe_, {0.35, Cabinet::kHeight, 0.0});
  put(shell_.back(), poster_, {0.75, 1.60, 0.0});
  put(shell_.left(), clock_, {0.75, 2.00, 0.0});
  put(*this, coat_stand_, {-kHalfX + 0.35, 0.0, kHalfZ - 0.40}, kFacesRight);
}

void Office::furnishCorner() {
  put(*this, armchair_, {0.62, 0.0, 2.08}, kFacesFront + 0.35);
  put(*this, standing_lamp_, {1.32, 0.0, 2.30}, kFacesLeft - 0.5);
  put(*this, plant_, {-kHalfX + 0.48, 0.0, -1.15});
}

}  // namespace coherency
