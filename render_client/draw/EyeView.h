#pragma once

#include "common/math/Frustum.h"
#include "common/math/TransformMatrix.h"

namespace coherency {

/// One eye's picture: where the eye is, what it takes in, and where on the target it goes (pixels, from the
/// bottom left corner as OpenGL has it); and where the vehicle stands that the eye goes with, the same for
/// both eyes: it is about there that things move, and what moves is lit and casts shadows (LampChoice,
/// OverheadShadow).
struct EyeView {
  TransformMatrix t_world_eye;  ///< rigid; -z ahead
  FieldOfView view;
  double near_m = 0.01;
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  TransformMatrix t_world_vehicle;  ///< rigid, on the floor; -z ahead
  double text_x = 0.0;              ///< where text begins, pixels from the view's top left corner
  double text_y = 0.0;
  double text_width = 0.0;  ///< lines are broken there, pixels; 0: at the view's right border
};

}  // namespace coherency
