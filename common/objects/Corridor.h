#pragma once

#include <array>

#include "common/objects/Boards.h"
#include "common/objects/ClosedDoors.h"
#include "common/objects/CorridorFittings.h"
#include "common/objects/Door.h"
#include "common/objects/Lamps.h"
#include "common/objects/Plants.h"
#include "common/objects/Room.h"
#include "common/objects/Seating.h"
#include "common/objects/WallFittings.h"
#include "common/objects/Window.h"

namespace coherency {

/// The corridor of the building (paper, Fig. 8(b)), 2.2 m (x) by 16.72 m (z) by 2.6 m about its origin. A
/// tall window at its front end, a lift at the other; on the left windows to the garden and the doorways of
/// the laboratory and the meeting room, on the right that of the office; doors that stay locked in between.
/// The doors of the three doorways are their rooms'.
class Corridor : public VRObject {
 public:
  static constexpr double kWidth = 2.2;
  static constexpr double kLength = 16.72;
  static constexpr double kHeight = 2.6;

  Corridor();

 private:
  void buildShell();
  void hangLamps();
  void furnishLeft();
  void furnishRight();
  void furnishEnds();

  BorderedFloor floor_;
  Shell shell_;
  Facade facade_;
  Window end_window_;
  WindowSill end_sill_;
  std::array<Window, 3> windows_;
  std::array<WindowSill, 3> sills_;
  std::array<LockedDoor, 4> doors_;
  LiftFront lift_;
  std::array<CeilingLamp, 6> lamps_;
  ExitSign exit_sign_;
  AirVent vent_;
  std::array<NamePlate, 7> plates_;
  NoticeBoard notice_board_;
  FireExtinguisher extinguisher_;
  std::array<Radiator, 2> radiators_;
  std::array<Bench, 2> benches_;
  HandRail rail_;
  std::array<Poster, 2> posters_;
  WallClock clock_;
  std::array<Plant, 3> plants_;
};

}  // namespace coherency
