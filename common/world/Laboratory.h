#pragma once

#include <array>

#include "common/world/Furnishings.h"
#include "common/world/Furniture.h"
#include "common/world/Openings.h"
#include "common/world/Room.h"
#include "common/world/Scene.h"

namespace coherency {

/// A room of a laboratory, 7 m (x) by 6 m (z) by 2.8 m about the world's origin: ahead of where one starts, a
/// table with three blocks; windows behind it; desk, shelf, cabinet and door round about.
class Laboratory : public Scene {
 public:
  static constexpr double kWidth = 7.0;
  static constexpr double kDepth = 6.0;
  static constexpr double kHeight = 2.8;
  static constexpr double kPalmOverBlock =
      0.035;  ///< middle of a palm that is about to grip one, over its top

  explicit Laboratory(const Rig& rig);

 private:
  void buildShell();
  void furnish();
  void placeBlocks();
  void light();
  void layOutFloor();

  Floor floor_;
  Ceiling ceiling_;
  Wall front_;
  Wall back_;
  Wall left_;
  Wall right_;
  std::array<Window, 3> windows_;
  Outdoors outdoors_;
  Door door_;
  std::array<CeilingLamp, 4> lamps_;
  Table table_;
  Block red_;
  Block green_;
  Block blue_;
  Bookshelf bookshelf_;
  Desk desk_;
  Monitor monitor_;
  DeskLamp desk_lamp_;
  Mug mug_;
  Cabinet cabinet_;
  Globe globe_;
  Plant plant_;
  Plant small_plant_;
  Poster poster_;
  Whiteboard whiteboard_;
  WallClock clock_;
};

}  // namespace coherency
