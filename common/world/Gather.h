#pragma once

#include <vector>

#include "common/scene/Light.h"
#include "common/scene/VRObject.h"
#include "common/world/WorldModel.h"

namespace coherency {

/// A door of the tree and the way its leaf goes.
struct DoorLeaf {
  VRObject* leaf = nullptr;
  Coord3 closed;
  Coord3 slide;
};

/// What the objects of a scene are to the world, found by their attributes.
struct Gathered {
  std::vector<SolidBox> solids;
  std::vector<DoorModel> doors;
  std::vector<DoorLeaf> leaves;  ///< of the doors, in the same order
  std::vector<MovableModel> movables;
  std::vector<VRObject*> carried;  ///< the movables' objects, in the same order
  std::vector<Light> lights;       ///< in the world
  std::vector<Ambient> ambients;
  std::vector<Coord3> targets;  ///< in the world
};

/// Walks `objects` and all below them. Throws std::invalid_argument naming the object where something solid,
/// a door or something to grasp is tilted or scaled, or lies beyond the end of the world.
Gathered gather(const std::vector<VRObject*>& objects);

}  // namespace coherency
