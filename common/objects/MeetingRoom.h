#pragma once

#include <array>

#include "common/objects/Boards.h"
#include "common/objects/Door.h"
#include "common/objects/Electronics.h"
#include "common/objects/Furnishings.h"
#include "common/objects/Lamps.h"
#include "common/objects/Plants.h"
#include "common/objects/Room.h"
#include "common/objects/Seating.h"
#include "common/objects/Storage.h"
#include "common/objects/Tables.h"
#include "common/objects/WallFittings.h"
#include "common/objects/Window.h"

namespace coherency {

/// Meeting room, 6.2 m (x) by 5.2 m (z) by 2.6 m about its origin: a long table with seven chairs before a
/// screen on the left wall, windows behind, the door to the right.
class MeetingRoom : public VRObject {
 public:
  static constexpr double kWidth = 6.2;
  static constexpr double kDepth = 5.2;
  static constexpr double kHeight = 2.6;

  MeetingRoom();

 private:
  void buildShell();
  void hangLamps();
  void furnishTable();
  void furnishWalls();

  TiledFloor floor_;
  Shell shell_;
  std::array<Window, 3> windows_;
  std::array<WindowSill, 3> sills_;
  std::array<Radiator, 2> radiators_;
  Door door_;
  std::array<CeilingLamp, 4> lamps_;
  std::array<PendantLamp, 2> pendants_;
  MeetingTable table_;
  std::array<Chair, 7> chairs_;
  std::array<Mug, 3> mugs_;
  PaperPile papers_;
  WallScreen screen_;
  Whiteboard whiteboard_;
  Cabinet sideboard_;
  Plant small_plant_;
  Plant plant_;
  Poster poster_;
  AirVent vent_;
};

}  // namespace coherency
