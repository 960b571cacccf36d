#pragma once

#include <vector>

#include "common/objects/Faces.h"
#include "common/scene/Primitives.h"

// What the walls and the ceiling of a corridor carry. On walls: origin at the middle of the side at the wall,
// z into the room. Metres.

namespace coherency {

/// Red bottle with a hose on a bracket, under its sign.
class FireExtinguisher : public VRObject {
 public:
  FireExtinguisher();

 private:
  Cylinder bottle_;
  Ellipsoid shoulder_;
  Polyhedron valve_;
  Polyhedron label_;
  Polyhedron hose_;
  Polyhedron sign_;
  Polyhedron sign_mark_;
};

/// Lit sign with an arrow and somebody who runs, read from both sides; hangs under its origin.
class ExitSign : public VRObject {
 public:
  ExitSign();

 private:
  Polyhedron hangers_;
  Polyhedron case_;
  Polyhedron faces_of_sign_;
  Polyhedron marks_;
};

/// Plate beside a door: a coloured band for whose room it is, and two lines.
class NamePlate : public VRObject {
 public:
  explicit NamePlate(std::uint32_t colour);

 private:
  Polyhedron plate_;
  Polyhedron band_;
  Polyhedron text_;
};

/// Wooden rail on brackets along the wall's x, from each `from` to its `to`; origin on the floor.
class HandRail : public VRObject {
 public:
  struct Stretch {
    double from, to;
  };
  explicit HandRail(const std::vector<Stretch>& stretches);

 private:
  Polyhedron rail_;
  Polyhedron brackets_;
};

}  // namespace coherency
