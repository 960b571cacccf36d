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

/// The laboratory, 7 m (x) by 6 m (z) by 2.8 m about its origin, empty in the middle: windows ahead, a desk
/// to the left, a bench and the master system's electronics behind, and to the right the door to the
/// corridor.
class Laboratory : public VRObject {
 public:
  static constexpr double kWidth = 7.0;
  static constexpr double kDepth = 6.0;
  static constexpr double kHeight = 2.8;

  Laboratory();

 private:
  void buildShell();
  void furnishFront();
  void furnishDesk();
  void furnishBack();
  void furnishRight();

  TiledFloor floor_;
  Shell shell_;
  Facade facade_;
  std::array<Window, 3> windows_;
  std::array<WindowSill, 3> sills_;
  std::array<Radiator, 2> radiators_;
  Door door_;
  std::array<CeilingLamp, 4> lamps_;
  Bookshelf bookshelf_;
  Poster poster_;
  Plant plant_;
  Desk desk_;
  SwivelChair chair_;
  Monitor monitor_;
  Computer computer_;
  DeskLamp desk_lamp_;
  Mug mug_;
  WasteBin bin_;
  Whiteboard whiteboard_;
  Workbench workbench_;
  std::array<Oscilloscope, 2> oscilloscopes_;
  std::array<ToolBox, 2> tool_boxes_;
  PaperPile papers_;
  Rack rack_;
  AirVent vent_;
  Poster back_poster_;
  Cabinet cabinet_;
  Globe globe_;
  Plant small_plant_;
  WallClock clock_;
};

}  // namespace coherency
