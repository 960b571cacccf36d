#pragma once

#include <string>
#include <vector>

#include "common/math/Coord3.h"

namespace coherency {

/// Refuses a face that cannot be drawn as a plane, convex polygon: fewer than three corners, a corner that is
/// not finite, neighbours that coincide, no area, corners out of the plane by more than 1e-6 of their extent,
/// or not convex. Throws std::invalid_argument beginning with `what`.
void checkFace(const std::vector<Coord3>& corners, const std::string& what);

}  // namespace coherency
