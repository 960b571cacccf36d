#pragma once

#include <array>

#include "common/scene/Primitives.h"

// What stands on the floor. Origins on the floor under the middle of the piece; what faces the room faces +z.
// Metres.

namespace coherency {

/// Work table with four legs.
class Table : public VRObject {
 public:
  static constexpr double kWidth = 1.4;  ///< along x
  static constexpr double kDepth = 0.7;  ///< along z
  static constexpr double kHeight = 0.72;

  Table();

 private:
  Box top_;
  Box edge_;
  Box apron_;
  std::array<Box, 4> legs_;
};

/// Desk with a drawer block.
class Desk : public VRObject {
 public:
  static constexpr double kHeight = 0.74;

  Desk();

 private:
  Box top_;
  Box side_;
  Box back_;
  Box drawers_;
  std::array<Box, 3> fronts_;
  std::array<Box, 3> grips_;
};

/// Open shelf, four boards high, full of books.
class Bookshelf : public VRObject {
 public:
  Bookshelf();

 private:
  void buildCase();
  void buildBooks();

  std::array<Box, 2> sides_;
  std::array<Box, 5> boards_;
  Box back_;
  std::array<Box, 36> books_;
  Cylinder vase_;
  Box file_box_;
};

/// Low cabinet with two doors.
class Cabinet : public VRObject {
 public:
  static constexpr double kHeight = 0.85;

  Cabinet();

 private:
  Box body_;
  Box top_;
  Box plinth_;
  std::array<Box, 2> doors_;
  std::array<Cylinder, 2> knobs_;
};

}  // namespace coherency
