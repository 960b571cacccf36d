#pragma once

#include "common/objects/Faces.h"

// What one works at. Origins on the floor under the middle of the piece; one sits at its +z side. Metres.

namespace coherency {

/// Work table with four legs.
class Table : public VRObject {
 public:
  static constexpr double kWidth = 1.4;  ///< along x
  static constexpr double kDepth = 0.7;  ///< along z
  static constexpr double kHeight = 0.72;

  Table();

 private:
  Polyhedron top_;
  Polyhedron frame_;
  Polyhedron apron_;
  Polyhedron legs_;
};

/// Desk with a drawer block on its right.
class Desk : public VRObject {
 public:
  static constexpr double kWidth = 1.5;
  static constexpr double kDepth = 0.68;
  static constexpr double kHeight = 0.74;

  Desk();

 private:
  Polyhedron top_;
  Polyhedron body_;
  Polyhedron fronts_;
  Polyhedron grips_;
};

/// Long table for eight on two columns.
class MeetingTable : public VRObject {
 public:
  static constexpr double kWidth = 2.8;
  static constexpr double kDepth = 1.1;
  static constexpr double kHeight = 0.74;

  MeetingTable();

 private:
  Polyhedron top_;
  Polyhedron edge_;
  Polyhedron columns_;
};

/// Long bench of a workshop, with a shelf below and one above.
class Workbench : public VRObject {
 public:
  static constexpr double kWidth = 2.4;
  static constexpr double kDepth = 0.7;
  static constexpr double kHeight = 0.86;
  static constexpr double kShelf = 1.42;  ///< height of the upper shelf's top

  Workbench();

 private:
  Polyhedron top_;
  Polyhedron frame_;
  Polyhedron shelves_;
};

}  // namespace coherency
