#pragma once

#include <vector>

#include "common/math/Coord3.h"

// Attributes of things that take up room: what stops driving, carries what is put down, is grasped or opens.
// Read by common/world/WorldModel. Lengths in metres, in the axes of the object that has the attribute, which
// may be turned about the vertical only and not scaled.

namespace coherency {

class VRObject;

/// A box nothing drives through; what is put down rests on its top.
struct Solid {
  Coord3 centre;
  Coord3 size;
};
/// All of an object's.
struct Solids {
  std::vector<Solid> boxes;
};

/// A cube about the object's origin that a hand can close upon, carry and put down.
struct Graspable {
  double edge = 0.0;
};

/// A door that slides open when somebody drives up to it.
struct Doorway {
  VRObject* leaf =
      nullptr;          ///< what slides; its position when closed is the one it has when the world begins
  Coord3 slide;         ///< from closed to open, in the axes of the leaf's parent
  Solid barrier;        ///< in the way until the door is open
  double sensor = 1.0;  ///< m from the barrier's middle, either side, within which feet or wheels open it
};

/// A point worth putting a hand to although there is nothing to grasp.
struct Reachable {
  Coord3 point;
};

}  // namespace coherency
