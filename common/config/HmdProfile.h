#pragma once

#include <optional>
#include <string>

#include "common/math/Frustum.h"
#include "common/math/Lens.h"
#include "common/math/Rotation.h"

namespace coherency {

/// What one eye is shown: the picture's field of view must equal the display's, or sizes and distances are
/// not what they are (paper, section IV.A.2).
struct EyeDisplay {
  FieldOfView view;          ///< with a lens: all that the lens shows of the panel
  YawPitchRoll axis;         ///< where the display's axis points, from straight ahead of the head
  std::optional<Lens> lens;  ///< none: a picture is seen as it is drawn
};

struct PanelSize {
  int width = 0;  ///< pixels an eye
  int height = 0;
};

/// A screen that stands before the operator and does not turn with the head (Ware, Arthur and Booth, Fish
/// tank virtual reality, 1993). It belongs to the seat: its middle lies ahead of the point between the eyes
/// of somebody who sits upright, and it goes where the seat goes.
struct Screen {
  double width_m = 0.0;  ///< of what shows the picture
  double height_m = 0.0;
  double distance_m = 0.0;
  double above_m = 0.0;   ///< its middle over the eyes
  double tilt_rad = 0.0;  ///< its top away from the operator
};

/// A display (configs/hmds/; docs/displays.md tells how to write one). The eyes' distance is the rig's, and
/// no display changes it. The defaults are configs/hmds/generic.toml's.
struct HmdProfile {
  std::string name = "generic";
  std::string source = "a generic display of 96 x 96 degrees an eye; no product";
  double near_m = 0.01;
  EyeDisplay left{fieldOfViewFromDegrees(52.0, 44.0, 48.0, 48.0), {}, {}};
  EyeDisplay right{fieldOfViewFromDegrees(44.0, 52.0, 48.0, 48.0), {}, {}};
  std::optional<PanelSize> panel;
  std::optional<Screen> screen;  ///< in place of both eyes' displays
};

/// `name` is a path where it ends in .toml, else one of hmdNames(). Throws ConfigError.
HmdProfile readHmdProfile(const std::string& name);
/// Profiles that come with the programs, with commas between.
std::string hmdNames();

/// The view between the eyes: the mean of both, straight ahead.
FieldOfView monoView(const HmdProfile& profile);

/// The same horizontal view on a picture of width x height pixels that are shaped as the panel's, square
/// where there is none: above and below are widened or cut in proportion. What an image of another shape than
/// the panel's shows; sizes stay true.
FieldOfView fitToPicture(const FieldOfView& view, const std::optional<PanelSize>& panel, int width,
                         int height);

}  // namespace coherency
