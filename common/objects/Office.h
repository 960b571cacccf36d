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

/// An office for two, 4.58 m (x) by 5.2 m (z) by 2.6 m about its origin: door to the left, windows to the
/// right.
class Office : public VRObject {
 public:
  static constexpr double kWidth = 4.58;
  static constexpr double kDepth = 5.2;
  static constexpr double kHeight = 2.6;

  Office();

 private:
  void buildShell();
  void furnishDesks();
  void furnishWalls();
  void furnishCorner();

  TiledFloor floor_;
  Shell shell_;
  std::array<Window, 2> windows_;
  std::array<WindowSill, 2> sills_;
  Radiator radiator_;
  Door door_;
  std::array<CeilingLamp, 2> lamps_;
  std::array<Desk, 2> desks_;
  std::array<SwivelChair, 2> chairs_;
  std::array<Monitor, 2> monitors_;
  std::array<Computer, 2> computers_;
  DeskLamp desk_lamp_;
  std::array<Mug, 2> mugs_;
  PaperPile papers_;
  WasteBin bin_;
  Bookshelf bookshelf_;
  Cabinet cabinet_;
  Globe globe_;
  NoticeBoard notice_board_;
  Poster poster_;
  WallClock clock_;
  CoatStand coat_stand_;
  Armchair armchair_;
  StandingLamp standing_lamp_;
  Plant plant_;
};

}  // namespace coherency
