#pragma once

namespace coherency {

/// Where the renderer trades speed for accuracy.
struct RendererSettings {
  int samples = 4;               ///< antialiasing samples a pixel, the nearest the driver has; 1: none
  bool shadows = true;           ///< of the scene's first light
  int shadow_resolution = 1024;  ///< texels a side
};

}  // namespace coherency
