#include "common/world/Laboratory.h"

#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr double kHalfX = Laboratory::kWidth / 2;
constexpr double kHalfZ = Laboratory::kDepth / 2;
constexpr std::uint32_t kWarmWhite = 0xE6DED0;
constexpr std::uint32_t kSage = 0xB4BFB2;
constexpr double kSkirting = 0.014;
constexpr double kTableZ = -1.2;
constexpr double kWorkplaceZ = kTableZ + Table::kDepth / 2 + 0.40;  // the stick just clears the table
constexpr double kStartZ = kTableZ + Table::kDepth / 2 + 2.1;

constexpr std::array<Wall::Opening, 3> kWindows = {
    {{-3.00, -1.80, 0.95, 2.35}, {-1.65, -0.45, 0.95, 2.35}, {-0.30, 0.90, 0.95, 2.35}}};
constexpr Wall::Opening kDoor{0.20, 1.15, 0.0, 2.06};

Wall::Form wall(double width, std::uint32_t colour, double inset, std::vector<Wall::Opening> openings = {}) {
  return {width, Laboratory::kHeight, colour, inset, std::move(openings)};
}

BasePose facingAhead(double x, double z) {
  BasePose pose;
  pose.x_nm = nanometresFromMetres(x);
  pose.z_nm = nanometresFromMetres(z);
  return pose;
}

}  // namespace

Laboratory::Laboratory(const Rig& rig)
    : Scene("laboratory", rig),
      floor_(14, 12, 0.5),
      ceiling_(kWidth, kDepth),
      front_(wall(kWidth, kSage, 0.0, {kWindows.begin(), kWindows.end()}), "front wall"),
      back_(wall(kWidth, kWarmWhite, 0.0), "back wall"),
      left_(wall(kDepth, kWarmWhite, kSkirting), "left wall"),
      right_(wall(kDepth, kWarmWhite, kSkirting, {kDoor}), "right wall"),
      windows_{Window(kWindows[0]), Window(kWindows[1]), Window(kWindows[2])},
      door_(kDoor),
      lamps_{CeilingLamp(1.2, 0.5), CeilingLamp(1.2, 0.5), CeilingLamp(1.2, 0.5), CeilingLamp(1.2, 0.5)},
      red_("red block", 0xC8433A),
      green_("green block", 0x4FA35B),
      blue_("blue block", 0x3F72C4),
      mug_(0xE9E3D6) {
  buildShell();
  furnish();
  placeBlocks();
  light();
  layOutFloor();
}

void Laboratory::buildShell() {
  for (VRObject* part :
       std::initializer_list<VRObject*>{&floor_, &ceiling_, &front_, &back_, &left_, &right_, &outdoors_})
    addMember(part);
  ceiling_.setPosition(0.0, kHeight, 0.0);
  front_.setPosition(0.0, 0.0, -kHalfZ);
  back_.setPosition(0.0, 0.0, kHalfZ);
  back_.setOrientation(TransformMatrix::rotationY(kTurn / 2));
  left_.setPosition(-kHalfX, 0.0, 0.0);
  left_.setOrientation(TransformMatrix::rotationY(kTurn / 4));
  right_.setPosition(kHalfX, 0.0, 0.0);
  right_.setOrientation(TransformMatrix::rotationY(-kTurn / 4));
  for (Window& window : windows_) front_.addMember(&window);
  right_.addMember(&door_);
  outdoors_.setPosition(0.0, 0.0, -kHalfZ - Wall::kThickness);
  for (std::size_t i = 0; i < lamps_.size(); ++i) {
    lamps_[i].setPosition(i % 2 == 0 ? -1.5 : 1.5, kHeight, i / 2 == 0 ? -1.3 : 1.3);
    addMember(&lamps_[i]);
  }
}

void Laboratory::furnish() {
  for (VRObject* part : std::initializer_list<VRObject*>{&table_, &bookshelf_, &desk_, &cabinet_, &plant_})
    addMember(part);
  table_.setPosition(0.0, 0.0, kTableZ);
  bookshelf_.setPosition(2.72, 0.0, -kHalfZ + 0.17);
  desk_.setPosition(-kHalfX + 0.37, 0.0, -0.9);
  desk_.setOrientation(TransformMatrix::rotationY(kTurn / 4));
  for (VRObject* part : std::initializer_list<VRObject*>{&monitor_, &desk_lamp_, &mug_})
    desk_.addMember(part);
  monitor_.setPosition(0.0, Desk::kHeight, -0.15);
  desk_lamp_.setPosition(0.58, Desk::kHeight, -0.18);
  mug_.setPosition(-0.42, Desk::kHeight, 0.05);
  cabinet_.setPosition(kHalfX - 0.24, 0.0, -1.35);
  cabinet_.setOrientation(TransformMatrix::rotationY(-kTurn / 4));
  cabinet_.addMember(&globe_);
  globe_.setPosition(-0.32, Cabinet::kHeight, 0.0);
  cabinet_.addMember(&small_plant_);
  small_plant_.setPosition(0.33, Cabinet::kHeight, 0.0);
  small_plant_.scale({0.5, 0.5, 0.5});
  plant_.setPosition(-kHalfX + 0.5, 0.0, -kHalfZ + 0.5);
  front_.addMember(&poster_);
  poster_.setPosition(1.5, 1.6, 0.0);
  left_.addMember(&whiteboard_);
  whiteboard_.setPosition(-0.95, 1.62, 0.0);
  right_.addMember(&clock_);
  clock_.setPosition((kDoor.left + kDoor.right) / 2, 2.4, 0.0);
}

/// Within reach of the right hand of an operator at the workplace.
void Laboratory::placeBlocks() {
  struct Place {
    Block* block;
    double x, z, turn;
  };
  for (const Place& p : {Place{&red_, -0.02, -0.54, 0.20}, Place{&green_, 0.16, -0.60, -0.35},
                         Place{&blue_, 0.33, -0.53, 0.45}}) {
    table_.addMember(p.block);
    p.block->setPosition(p.x, Table::kHeight, kWorkplaceZ + p.z - kTableZ);
    p.block->setOrientation(TransformMatrix::rotationY(p.turn));
    addTarget(p.block->globalPosition() + Coord3{0.0, Block::kEdge + kPalmOverBlock, 0.0});
  }
}

void Laboratory::light() {
  setAmbient({0.40, 0.42, 0.45}, {0.26, 0.24, 0.21});
  addLight({{0.45, kHeight - 0.08, -0.55}, {1.0, 0.96, 0.90}, 1.5});
  addLight({{-1.6, kHeight - 0.2, 1.2}, {1.0, 0.97, 0.92}, 0.7});
  addLight({{1.7, kHeight - 0.2, 1.2}, {1.0, 0.97, 0.92}, 0.7});
  addLight({{-1.0, 1.8, -kHalfZ + 0.3}, {0.86, 0.94, 1.0}, 0.5});  // the windows
}

void Laboratory::layOutFloor() {
  setStart(facingAhead(0.0, kStartZ));
  setWorkplace(facingAhead(0.0, kWorkplaceZ));
  // The seat turns on its base: a platform's length is kept from the walls, the table and the desk's front.
  setDriveArea({-2.4, 2.4, kWorkplaceZ, 1.9});
}

}  // namespace coherency
