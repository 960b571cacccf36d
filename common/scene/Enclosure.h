#pragma once

#include <vector>

#include "common/math/Coord3.h"

namespace coherency {

/// Attribute of what encloses a room, all of it fixed and opaque, so that from inside the box nothing outside
/// of it is seen but through the openings. Renderers leave out what cannot be seen (cull/Enclosures.h): an
/// opening that is not declared shows nothing. Metres, in the axes of the object that has the attribute,
/// which may be turned and moved, but not scaled.
struct Enclosure {
  Coord3 centre;
  Coord3 size;
  std::vector<std::vector<Coord3>> openings;  ///< flat and convex, on the box's faces; corners in a circle
};

}  // namespace coherency
