#pragma once

#include "common/objects/Wall.h"

// What fills a window's opening, in the frame of the wall. Metres.

namespace coherency {

/// Two casements under top lights, in a frame, with a handle; in an outer wall. 30 polygons.
class Window : public VRObject {
 public:
  explicit Window(const Outline& opening);

 private:
  Polyhedron frame_;
  Polyhedron bars_;
  Polyhedron handle_;
};

/// The board under a window.
class WindowSill : public VRObject {
 public:
  explicit WindowSill(const Outline& opening);

 private:
  Polyhedron board_;
};

}  // namespace coherency
