#pragma once

#include <array>

#include "common/objects/Faces.h"
#include "common/scene/Primitives.h"

// Devices that stand on furniture or beside it. Origins at the bottom, facing +z. Metres.

namespace coherency {

/// Computer screen on its foot, with a keyboard and a mouse.
class Monitor : public VRObject {
 public:
  Monitor();

 private:
  Polyhedron case_;
  Rectangle screen_;
  std::array<Polyhedron, 3> lines_;
  Polyhedron keyboard_;
  Polyhedron keys_;
};

/// The computer itself, to stand under a desk; its fan is heard.
class Computer : public VRObject {
 public:
  static constexpr double kWidth = 0.19;
  static constexpr double kHeight = 0.42;

  Computer();

 private:
  Polyhedron case_;
  Polyhedron front_;
  Rectangle lamp_;
};

/// Measuring instrument with a screen on which a wave is to be seen.
class Oscilloscope : public VRObject {
 public:
  Oscilloscope();

 private:
  Polyhedron case_;
  Rectangle screen_;
  Polyhedron wave_;
  Polyhedron knobs_;
};

}  // namespace coherency
