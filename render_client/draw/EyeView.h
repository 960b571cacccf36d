#pragma once

#include "common/math/Frustum.h"
#include "common/math/TransformMatrix.h"

namespace coherency {

/// One eye's picture: where the eye is, what it takes in, and where on the target it goes (pixels, from the
/// bottom left corner as OpenGL has it).
struct EyeView {
  TransformMatrix t_world_eye;  ///< rigid; -z ahead
  FieldOfView view;
  double near_m = 0.01;
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

}  // namespace coherency
