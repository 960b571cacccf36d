#pragma once

#include "render_client/compile/BakeSettings.h"

namespace coherency {

/// Where the renderer trades speed for accuracy.
struct RendererSettings {
  int samples = 4;              ///< antialiasing samples a pixel, the nearest the driver has; 1: none
  bool shadows = true;          ///< of what moves
  int shadow_resolution = 768;  ///< texels a side, for 3.2 m
  bool two_vehicles = true;     ///< false: no shadows about EyeView::t_world_other_vehicle
  bool clip = true;             ///< leave out what is not in view; false is for measuring and testing
  /// Curved surfaces are drawn coarser where that moves nothing by more than this, as seen from between the
  /// eyes, in pixels of a picture's middle (DetailChoice); 0: never. Needs EyeView::cyclopean.
  double detail_px = 0.25;
  double smallest_px = 0.0;  ///< likewise: objects, or blocks of them, smaller across are left out; 0: none
  BakeSettings bake = {};    ///< light of what never moves
};

}  // namespace coherency
