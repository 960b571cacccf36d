#pragma once

#include "common/config/HmdProfile.h"
#include "render_client/draw/EyeViews.h"

namespace coherency {

/// Pixels of the picture that is drawn for an eye whose part of the display is `width` x `height`: as many,
/// or with a lens so many that the lens's middle, where it magnifies most, shows each as one of the panel's.
/// `scale` times that to each side, for finer edges or for more speed. The same for both eyes.
PanelSize pictureSize(const HmdProfile& hmd, EyeChoice eyes, int width, int height, double scale);

/// Where a panel's image goes on a part of the display of another size or shape: as large as fits, in its
/// middle, so that all directions stay true.
struct PanelPlace {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};
PanelPlace placePanel(const PanelSize& panel, int width, int height);

}  // namespace coherency
