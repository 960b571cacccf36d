#pragma once

#include <array>

#include "common/objects/Faces.h"
#include "common/scene/Primitives.h"

// What one reads on walls: origin at the middle of the side at the wall, z into the room. Metres.

namespace coherency {

/// Board with a drawing in marker, and its tray.
class Whiteboard : public VRObject {
 public:
  Whiteboard();

 private:
  Polyhedron frame_;
  Rectangle surface_;
  std::array<Polyhedron, 4> strokes_;  ///< those of one colour
  Polyhedron pen_;
};

/// Cork in a frame, with papers pinned to it.
class NoticeBoard : public VRObject {
 public:
  static constexpr double kWidth = 1.5;
  static constexpr double kHeight = 0.95;

  NoticeBoard();

 private:
  Polyhedron frame_;
  Rectangle cork_;
  std::array<Polyhedron, 3> papers_;
  Polyhedron text_;
  Polyhedron pins_;
};

/// Two eyes that see one world: a print in a frame.
class Poster : public VRObject {
 public:
  explicit Poster(std::uint32_t colour = 0x2F5D73);

 private:
  Polyhedron frame_;
  Rectangle paper_;
  Rectangle band_;
  Polyhedron whites_;
  Polyhedron pupils_;
  Polyhedron text_;
};

/// Large flat screen on which a picture is shown.
class WallScreen : public VRObject {
 public:
  WallScreen();

 private:
  Polyhedron case_;
  Rectangle picture_;
  Polyhedron bars_;
  Polyhedron axes_;
};

}  // namespace coherency
