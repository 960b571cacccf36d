#include "render_client/draw/PictureSize.h"

#include <algorithm>
#include <cmath>

namespace coherency {
namespace {

int pixels(double wanted) {
  constexpr double kMost = 1e6;  // more than any driver has; it says so
  return static_cast<int>(std::lround(std::clamp(wanted, 1.0, kMost)));
}

}  // namespace

PanelSize pictureSize(const HmdProfile& hmd, EyeChoice eyes, int width, int height, double scale) {
  if (!hasLens(hmd, eyes)) return {pixels(scale * width), pixels(scale * height)};
  const PanelPlace place = placePanel(*hmd.panel, width, height);
  scale *= static_cast<double>(place.width) / hmd.panel->width;
  double across = 0.0;
  double upright = 0.0;
  for (const EyeDisplay* eye : {&hmd.left, &hmd.right}) {
    const double per_tangent = scale * eye->lens->pixelsPerTangent();
    across = std::max(across, per_tangent * (eye->view.tan_left + eye->view.tan_right));
    upright = std::max(upright, per_tangent * (eye->view.tan_down + eye->view.tan_up));
  }
  return {pixels(across), pixels(upright)};
}

PanelPlace placePanel(const PanelSize& panel, int width, int height) {
  const double factor =
      std::min(static_cast<double>(width) / panel.width, static_cast<double>(height) / panel.height);
  const int placed_width = pixels(factor * panel.width);
  const int placed_height = pixels(factor * panel.height);
  return {(width - placed_width) / 2, (height - placed_height) / 2, placed_width, placed_height};
}

}  // namespace coherency
