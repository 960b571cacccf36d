#pragma once

#include "common/objects/Faces.h"
#include "common/objects/Pad.h"
#include "common/scene/Primitives.h"

// What one sits on. Origins on the floor under the middle of the seat; who sits faces +z. Metres.

namespace coherency {

/// Upholstered chair with four steel legs.
class Chair : public VRObject {
 public:
  explicit Chair(std::uint32_t colour);

 private:
  Pad seat_;
  Pad back_;
  Polyhedron frame_;
};

/// Desk chair that turns, on five castors.
class SwivelChair : public VRObject {
 public:
  explicit SwivelChair(std::uint32_t colour);

 private:
  Pad seat_;
  Pad back_;
  Polyhedron spine_;
  Cylinder column_;
  Polyhedron star_;
};

/// Wooden bench for two, without a back.
class Bench : public VRObject {
 public:
  static constexpr double kWidth = 1.5;
  static constexpr double kDepth = 0.40;
  static constexpr double kHeight = 0.44;

  Bench();

 private:
  Polyhedron slats_;
  Polyhedron legs_;
};

/// Armchair, low and soft.
class Armchair : public VRObject {
 public:
  explicit Armchair(std::uint32_t colour);

 private:
  Pad seat_;
  Pad back_;
  Pad left_arm_;
  Pad right_arm_;
  Polyhedron feet_;
};

}  // namespace coherency
