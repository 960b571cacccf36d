#pragma once

#include <optional>

#include "common/math/Frustum.h"
#include "common/math/TransformMatrix.h"
#include "render_client/cull/DetailChoice.h"

namespace coherency {

/// One eye's picture: where the eye is, what it takes in, and where on the target it goes (pixels, from the
/// bottom left corner as OpenGL has it); and where the vehicle stands that the eye goes with, the same for
/// both eyes, and where the other one of the scene does: it is about these that what moves casts shadows
/// (OverheadShadow).
struct EyeView {
  TransformMatrix t_world_eye;  ///< rigid; -z ahead
  FieldOfView view;
  double near_m = 0.01;
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  TransformMatrix t_world_vehicle;                                      ///< rigid, on the floor; -z ahead
  std::optional<TransformMatrix> t_world_other_vehicle = std::nullopt;  ///< none where there is but one
  /// Where text begins, pixels from the view's top left corner. Text lies in a plane of the head's; the
  /// pixels are those that the view would have with its axes turned into the head's.
  double text_x = 0.0;
  double text_y = 0.0;
  double text_width = 0.0;          ///< lines are broken there, pixels; 0: at the view's right border
  TransformMatrix t_eye_head = {};  ///< rotation only; other than none for displays that are canted
  /// The same for both eyes, whichever of them is drawn; without it everything is drawn in full detail.
  std::optional<CyclopeanEye> cyclopean = std::nullopt;
};

}  // namespace coherency
