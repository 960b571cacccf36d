#include "render_client/cull/DetailChoice.h"

#include <algorithm>

namespace coherency {

double DetailChoice::nearest(const Sphere& sphere) const {
  return std::max(norm(sphere.centre - eye_.position) - eye_.eye_offset - sphere.radius, 0.0);
}

}  // namespace coherency
