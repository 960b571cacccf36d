#pragma once

#include <array>

#include "common/objects/Wall.h"
#include "common/scene/Primitives.h"

namespace coherency {

/// A sliding door in the wall between two rooms, in the frame of that wall: the leaf runs in the middle of
/// the wall and into it, to the right, when somebody drives up. Frames, handles, kick plates and sensors on
/// both sides alike. 122 polygons.
class Door : public VRObject {
 public:
  static constexpr double kWidth = 1.25;  ///< of the opening
  static constexpr double kHeight = 2.06;
  static constexpr double kClear = 1.12;  ///< width that is free when it is open

  /// The opening it needs, whose left edge is at `left`; the wall to its right must have room for the leaf.
  static constexpr Outline opening(double left) { return {left, left + kWidth, 0.0, kHeight}; }

  explicit Door(const Outline& opening);

 private:
  void buildFrame(const Outline& opening);
  void buildLeaf(double width, double height);
  void buildPane(const Outline& pane);
  void buildHandles(double edge);
  void buildSensors(const Outline& opening);

  Polyhedron frame_;
  Polyhedron threshold_;
  VRObject leaf_{"door leaf"};
  Polyhedron panel_;
  Polyhedron beads_;
  Polyhedron bands_;
  Polyhedron label_;
  Polyhedron arrow_;
  Polyhedron kick_plates_;
  Polyhedron handle_posts_;
  std::array<Cylinder, 2> handles_;
  Polyhedron sensors_;
  Polyhedron sensor_eyes_;
  Polyhedron sensor_lamps_;
};

}  // namespace coherency
