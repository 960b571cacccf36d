#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/config/HmdProfile.h"

namespace coherency {

/// Pixels of the picture that a mesh between its vertices may be off the lens's own curves.
inline constexpr double kDistortionErrorPx = 0.1;

/// A corner of the mesh that makes of a picture what a panel must show (Watson and Hodges, Using texture maps
/// to correct for optical distortion in head-mounted displays, 1995). On the panel and on the picture x and y
/// go from 0 to 1, from the bottom left corner as OpenGL has it.
struct DistortionVertex {
  using Point = std::array<float, 2>;
  Point panel;
  std::array<Point, 3> picture;  ///< where each colour is taken from: red, green, blue
};

/// Triangles between rings about the lens centre, the last of which is the lens's border; parts of it lie
/// beside the panel. Rings are as close as the curves bend.
struct DistortionMesh {
  int rings = 0;
  int spokes = 0;
  std::vector<DistortionVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< counterclockwise
};

/// Made once at start-up, in double. `picture` is of display.view; no colour is off by more than `error_px`.
/// Throws std::runtime_error where more than 1024 rings or spokes would be needed. Precondition: the display
/// has a lens.
DistortionMesh distortionMesh(const EyeDisplay& display, const PanelSize& panel, const PanelSize& picture,
                              double error_px = kDistortionErrorPx);

}  // namespace coherency
