#include "common/objects/MeetingRoom.h"

#include "common/objects/Finish.h"

namespace coherency {

namespace {

constexpr double kHalfX = MeetingRoom::kWidth / 2;
constexpr double kHalfZ = MeetingRoom::kDepth / 2;
constexpr Coord3 kTable{-0.45, 0.0, 0.45};

constexpr std::array<Outline, 3> kWindows = {
    {{-2.35, -0.95, 0.85, 2.20}, {-0.70, 0.70, 0.85, 2.20}, {0.95, 2.35, 0.85, 2.20}}};
constexpr Outline kDoor = Door::opening(-1.46);

Shell::Form shell() {
  return {MeetingRoom::kWidth,
          MeetingRoom::kDepth,
          MeetingRoom::kHeight,
          plainWall(finish::kWarmWhite),
          plainWall(finish::kWarmWhite, {kWindows.begin(), kWindows.end()}),
          plainWall(finish::kBlueGrey),
          plainWall(finish::kWarmWhite, {kDoor})};
}

CeilingLamp lamp() {
  return {0.6, 0.6, 1.7};
}

Chair chair() {
  return Chair(0xB8704A);
}

}  // namespace

MeetingRoom::MeetingRoom()
    : VRObject("meeting room"),
      floor_(kWidth, kDepth, 0.775, 0x8A8F80, 0x838879),
      shell_(shell()),
      windows_{Window(kWindows[0]), Window(kWindows[1]), Window(kWindows[2])},
      sills_{WindowSill(kWindows[0]), WindowSill(kWindows[1]), WindowSill(kWindows[2])},
      radiators_{Radiator(1.2), Radiator(1.2)},
      door_(kDoor),
      lamps_{lamp(), lamp(), lamp(), lamp()},
      pendants_{PendantLamp(0.85, 0.3), PendantLamp(0.85, 0.3)},
      chairs_{chair(), chair(), chair(), chair(), chair(), chair(), chair()},
      mugs_{Mug(0xE9E3D6), Mug(0x4E8A8B), Mug(finish::kRust)},
      small_plant_(0.45),
      plant_(1.05),
      poster_(0x4B6350) {
  attach(finish::ambient());
  buildShell();
  hangLamps();
  furnishTable();
  furnishWalls();
}

void MeetingRoom::buildShell() {
  put(*this, floor_, {});
  put(*this, shell_, {});
  for (std::size_t i = 0; i < windows_.size(); ++i) {
    put(shell_.back(), windows_[i], {});
    put(shell_.back(), sills_[i], {});
  }
  put(shell_.back(), radiators_[0], {-1.65, 0.0, 0.0});
  put(shell_.back(), radiators_[1], {1.65, 0.0, 0.0});
  put(shell_.right(), door_, {});
}

void MeetingRoom::hangLamps() {
  for (std::size_t i = 0; i < lamps_.size(); ++i)
    put(*this, lamps_[i], {i % 2 == 0 ? -1.9 : 1.9, kHeight, i / 2 == 0 ? -1.5 : 1.6});
  for (std::size_t i = 0; i < pendants_.size(); ++i)
    put(*this, pendants_[i], kTable + Coord3{i == 0 ? -0.65 : 0.65, kHeight, 0.0});
}

/// Three chairs on either side and one at the end; not all quite straight, as people leave them.
void MeetingRoom::furnishTable() {
  put(*this, table_, kTable);
  constexpr std::array<double, 6> kTurned = {0.08, -0.12, 0.0, 0.10, 0.0, -0.22};
  for (std::size_t i = 0; i < 6; ++i) {
    const double x = -0.9 + 0.9 * static_cast<double>(i % 3);
    const bool front = i < 3;
    const double out = MeetingTable::kDepth / 2 + (i == 5 ? 0.36 : 0.22);
    put(*this, chairs_[i], kTable + Coord3{x, 0.0, front ? -out : out},
        (front ? kFacesBack : kFacesFront) + kTurned[i]);
  }
  put(*this, chairs_[6], kTable + Coord3{MeetingTable::kWidth / 2 + 0.30, 0.0, 0.05}, kFacesLeft - 0.15);
  put(table_, mugs_[0], {-0.75, MeetingTable::kHeight, -0.28}, 0.6);
  put(table_, mugs_[1], {0.35, MeetingTable::kHeight, 0.30}, 2.0);
  put(table_, mugs_[2], {1.05, MeetingTable::kHeight, -0.18}, -0.9);
  put(table_, papers_, {-0.15, MeetingTable::kHeight, -0.05}, 0.5);
}

void MeetingRoom::furnishWalls() {
  put(shell_.left(), screen_, {-kTable.z, 1.45, 0.0});
  put(shell_.front(), whiteboard_, {-0.30, 1.55, 0.0});
  put(*this, sideboard_, {kHalfX - Cabinet::kDepth / 2 - 0.02, 0.0, 1.55}, kFacesLeft);
  put(sideboard_, small_plant_, {0.38, Cabinet::kHeight, 0.0});
  put(shell_.right(), poster_, {1.55, 1.60, 0.0});
  put(*this, plant_, {-kHalfX + 0.55, 0.0, -kHalfZ + 0.55});
  put(shell_.front(), vent_, {2.0, 2.38, 0.0});
}

}  // namespace coherency
