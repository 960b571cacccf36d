#pragma once

#include <array>

#include "common/objects/Faces.h"
#include "common/scene/Primitives.h"

// What gives light. `intensity` is that of the light they shed (Light): irradiance at 1 m. Metres.

namespace coherency {

/// Shining panel in a frame, under its origin.
class CeilingLamp : public VRObject {
 public:
  CeilingLamp(double width, double depth, double intensity);

 private:
  Polyhedron frame_;
  Polyhedron panel_;
};

/// Shade that hangs from its origin on a cord.
class PendantLamp : public VRObject {
 public:
  PendantLamp(double drop, double intensity);

 private:
  Cylinder rose_;
  Cylinder cord_;
  Polyhedron shade_;
  Ellipsoid bulb_;
};

/// Stands on the floor; its shade hangs in front of it at the end of an arm.
class StandingLamp : public VRObject {
 public:
  StandingLamp();

 private:
  Cylinder foot_;
  Cylinder pole_;
  Cylinder arm_;
  Polyhedron shade_;
  Ellipsoid bulb_;
};

/// Stands on a desk, and shines down in front of it.
class DeskLamp : public VRObject {
 public:
  DeskLamp();

 private:
  Cylinder foot_;
  Cylinder stem_;
  Cylinder arm_;
  Polyhedron shade_;
  Ellipsoid bulb_;
};

}  // namespace coherency
