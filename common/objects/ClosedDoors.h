#pragma once

#include "common/objects/Faces.h"

// Doors that stay closed: what they lead to is not part of the world. In the frame of the wall whose opening
// they fill, seen from its room only. Metres.

namespace coherency {

/// A hinged door of steel with a lever handle, locked.
class LockedDoor : public VRObject {
 public:
  static constexpr double kWidth = 0.92;  ///< of the opening
  static constexpr double kHeight = 2.06;
  static constexpr Outline opening(double left) { return {left, left + kWidth, 0.0, kHeight}; }

  explicit LockedDoor(const Outline& opening);

 private:
  Polyhedron frame_;
  Polyhedron leaf_;
  Polyhedron sill_;
  Polyhedron louvre_;
  Polyhedron rosette_;
  Polyhedron lever_;
};

/// A lift's two leaves in their portal, with a floor indicator above and a call panel to the right.
class LiftFront : public VRObject {
 public:
  static constexpr double kWidth = 1.10;  ///< of the opening
  static constexpr double kHeight = 2.10;
  static constexpr Outline opening(double left) { return {left, left + kWidth, 0.0, kHeight}; }

  explicit LiftFront(const Outline& opening);

 private:
  void buildPortal(const Outline& opening);
  void buildIndicator(const Outline& opening);
  void buildCallPanel(const Outline& opening);

  Polyhedron portal_;
  Polyhedron leaves_;
  Polyhedron seam_;
  Polyhedron sill_;
  Polyhedron indicator_;
  Polyhedron arrow_;
  Polyhedron call_panel_;
  Polyhedron buttons_;
};

}  // namespace coherency
