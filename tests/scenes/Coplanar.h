#pragma once

#include <string>
#include <vector>

#include "common/scene/VRObject.h"

namespace coherency::scenes {

/// Two faces that a depth buffer cannot tell apart: of different objects, seen from the same side, and less
/// than half a millimetre apart all over the piece that they share.
struct Fight {
  std::string one;  ///< path
  std::string other;
  double area = 0.0;  ///< m^2
  Coord3 at;          ///< in the middle of it, in the root's frame
};

/// All pairs below `root` that share more than a square centimetre.
std::vector<Fight> coplanarFaces(const VRObject& root);

}  // namespace coherency::scenes
