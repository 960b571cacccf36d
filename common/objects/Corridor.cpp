#include "common/objects/Corridor.h"

#include "common/objects/Finish.h"

namespace coherency {

namespace {

constexpr double kHalfX = Corridor::kWidth / 2;
constexpr double kHalfZ = Corridor::kLength / 2;

// Along the walls by z: as one who looks from the left to the right sees them. The right wall's own x is z.
constexpr std::array<Outline, 3> kWindows = {
    {{-7.95, -6.75, 0.85, 2.20}, {-6.40, -5.20, 0.85, 2.20}, {-4.85, -3.65, 0.85, 2.20}}};
constexpr Outline kLaboratory = Door::opening(0.10);
constexpr Outline kMeetingRoom = Door::opening(4.30);
constexpr Outline kOffice = Door::opening(0.10);
constexpr std::array<Outline, 4> kLocked = {{LockedDoor::opening(-7.60), LockedDoor::opening(-4.50),
                                             LockedDoor::opening(3.50), LockedDoor::opening(6.40)}};
constexpr std::size_t kStairs = 1;  // the locked door to which the exit sign points
constexpr Outline kEndWindow{-0.60, 0.60, 0.35, 2.25};
constexpr Outline kLift = LiftFront::opening(-0.75);

Wall::Form wall(std::vector<Outline> openings) {
  Wall::Form form{};
  form.colour = finish::kWarmWhite;
  form.openings = std::move(openings);
  form.dado = 1.05;
  form.dado_colour = 0xA8BAB6;
  return form;
}

Shell::Form shell() {
  std::vector<Outline> left = {fromBehind(kLaboratory), fromBehind(kMeetingRoom)};
  for (const Outline& window : kWindows) left.push_back(fromBehind(window));
  std::vector<Outline> right = {kOffice};
  right.insert(right.end(), kLocked.begin(), kLocked.end());
  return {Corridor::kWidth, Corridor::kLength, Corridor::kHeight, wall({kEndWindow}),
          wall({kLift}),    wall(left),        wall(right)};
}

CeilingLamp lamp() {
  return {0.32, 1.2, 2.2};
}

}  // namespace

Corridor::Corridor()
    : VRObject("corridor"),
      floor_(kWidth, kLength, 0.16, 0xBFB199, 0x8E8673),
      shell_(shell()),
      facade_(-kHalfZ - Wall::kOuterThickness, -3.24, {kWindows.begin(), kWindows.end()}),
      end_window_(kEndWindow),
      end_sill_(kEndWindow),
      windows_{Window(fromBehind(kWindows[0])), Window(fromBehind(kWindows[1])),
               Window(fromBehind(kWindows[2]))},
      sills_{WindowSill(fromBehind(kWindows[0])), WindowSill(fromBehind(kWindows[1])),
             WindowSill(fromBehind(kWindows[2]))},
      doors_{LockedDoor(kLocked[0]), LockedDoor(kLocked[1]), LockedDoor(kLocked[2]), LockedDoor(kLocked[3])},
      lift_(kLift),
      lamps_{lamp(), lamp(), lamp(), lamp(), lamp(), lamp()},
      plates_{NamePlate(0x7F9A94),     NamePlate(0x1F9D62),      NamePlate(0x7F9A94),
              NamePlate(0x7F9A94),     NamePlate(finish::kRust), NamePlate(finish::kRust),
              NamePlate(finish::kRust)},
      radiators_{Radiator(1.0), Radiator(1.0)},
      rail_({{-6.40, -4.78}, {-3.30, -0.20}, {1.62, 3.25}, {4.75, 6.15}}),
      posters_{Poster(0x7A4A3A), Poster()},
      plants_{Plant(0.85), Plant(0.85), Plant(0.75)} {
  attach(finish::ambient());
  buildShell();
  hangLamps();
  furnishLeft();
  furnishRight();
  furnishEnds();
}

void Corridor::buildShell() {
  put(*this, floor_, {});
  put(*this, shell_, {});
  put(*this, facade_, {-kHalfX - Wall::kOuterThickness, 0.0, 0.0}, kFacesLeft);
  put(shell_.front(), end_window_, {});
  put(shell_.front(), end_sill_, {});
  for (std::size_t i = 0; i < windows_.size(); ++i) {
    put(shell_.left(), windows_[i], {});
    put(shell_.left(), sills_[i], {});
  }
  for (LockedDoor& door : doors_) put(shell_.right(), door, {});
  put(shell_.back(), lift_, {});
}

void Corridor::hangLamps() {
  for (std::size_t i = 0; i < lamps_.size(); ++i)
    put(*this, lamps_[i], {0.0, kHeight, -7.0 + 2.8 * static_cast<double>(i)});
  put(*this, exit_sign_, {0.0, kHeight, kLocked[kStairs].middle(0.0).x}, kFacesFront);
}

void Corridor::furnishLeft() {
  put(shell_.left(), radiators_[0], {7.35, 0.0, 0.0});
  put(shell_.left(), radiators_[1], {4.25, 0.0, 0.0});
  put(*this, benches_[0], {-kHalfX + Bench::kDepth / 2 + 0.03, 0.0, -5.80}, kFacesRight);
  put(shell_.left(), notice_board_, {1.75, 1.55, 0.0});
  put(shell_.left(), plates_[4], {-kLaboratory.left + 0.24, 1.50, 0.0});
  put(shell_.left(), extinguisher_, {-3.30, 0.62, 0.0});
  put(shell_.left(), plates_[5], {-kMeetingRoom.left + 0.24, 1.50, 0.0});
  put(shell_.left(), posters_[0], {-7.15, 1.60, 0.0});
  put(*this, benches_[1], {-kHalfX + Bench::kDepth / 2 + 0.03, 0.0, 7.15}, kFacesRight);
  put(*this, plants_[2], {-kHalfX + 0.30, 0.0, -3.05});
}

void Corridor::furnishRight() {
  put(shell_.right(), rail_, {});
  for (std::size_t i = 0; i < doors_.size(); ++i)
    put(shell_.right(), plates_[i], {kLocked[i].right + 0.24, 1.50, 0.0});
  put(shell_.right(), plates_[6], {kOffice.right + 0.24, 1.50, 0.0});
  put(shell_.right(), posters_[1], {-1.75, 1.60, 0.0});
  put(shell_.right(), clock_, {2.40, 2.00, 0.0});
  put(shell_.right(), vent_, {-5.60, 2.40, 0.0});
}

void Corridor::furnishEnds() {
  for (std::size_t i = 0; i < 2; ++i)
    put(*this, plants_[i], {i == 0 ? -0.68 : 0.68, 0.0, -kHalfZ + 0.45}, 0.7);
}

}  // namespace coherency
