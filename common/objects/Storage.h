#pragma once

#include <array>

#include "common/body/Loft.h"
#include "common/objects/Faces.h"
#include "common/scene/Physical.h"
#include "common/scene/Primitives.h"

// What keeps things. Origins on the floor under the middle of the piece; its front faces +z. Metres.

namespace coherency {

/// Open shelf, four boards high, with books, a vase and a box of files.
class Bookshelf : public VRObject {
 public:
  static constexpr double kWidth = 1.2;
  static constexpr double kDepth = 0.30;
  static constexpr double kHeight = 2.0;

  Bookshelf();

 private:
  void buildCase(Solids& solids);
  void buildBooks(Solids& solids);

  Polyhedron case_;
  Polyhedron back_;
  std::array<Polyhedron, 7> books_;  ///< those of one colour
  Cylinder vase_;
  Polyhedron file_boxes_;
};

/// Low cabinet with two doors.
class Cabinet : public VRObject {
 public:
  static constexpr double kWidth = 1.22;
  static constexpr double kDepth = 0.44;
  static constexpr double kHeight = 0.85;

  Cabinet();

 private:
  Polyhedron body_;
  Polyhedron top_;
  Polyhedron plinth_;
  Polyhedron doors_;
  std::array<Cylinder, 2> knobs_;
};

/// Steel cabinet with the electronics of the master system; its fans are heard.
class Rack : public VRObject {
 public:
  static constexpr double kWidth = 0.60;
  static constexpr double kDepth = 0.70;
  static constexpr double kHeight = 1.80;

  Rack();

 private:
  void buildUnits();

  Polyhedron case_;
  Polyhedron units_;
  Polyhedron slots_;
  Polyhedron lamps_;
  Polyhedron screen_;
};

/// Pole with hooks, and a coat on one of them.
class CoatStand : public VRObject {
 public:
  CoatStand();

 private:
  Cylinder foot_;
  Cylinder pole_;
  Polyhedron hooks_;
  Loft coat_;
};

}  // namespace coherency
