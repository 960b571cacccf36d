#pragma once

#include <cstdint>
#include <vector>

#include "common/scene/VRObject.h"

namespace coherency {

/// Which object shows at each pixel's centre, rows from the top.
struct IdImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> ids;        ///< 0: none; else objects[id - 1]
  std::vector<const VRObject*> objects;  ///< all that show faces, in view or not
};

}  // namespace coherency
