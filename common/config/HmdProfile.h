#pragma once

#include <string>

#include "common/math/Frustum.h"

namespace coherency {

/// What a display shows each eye (configs/hmds/): the picture's field of view must equal the display's, or
/// sizes and distances are not what they are (paper, section IV.A.2). The defaults are
/// configs/hmds/generic.toml's.
struct HmdProfile {
  std::string name = "generic";
  std::string source = "a generic display of 96 x 96 degrees an eye; no product";
  double near_m = 0.01;
  FieldOfView left = fieldOfViewFromDegrees(52.0, 44.0, 48.0, 48.0);
  FieldOfView right = fieldOfViewFromDegrees(44.0, 52.0, 48.0, 48.0);
};

/// `name` is a path where it ends in .toml, else one of hmdNames(). Throws ConfigError.
HmdProfile readHmdProfile(const std::string& name);
/// Profiles that come with the programs, with commas between.
std::string hmdNames();

/// The view between the eyes: the mean of both.
FieldOfView monoView(const HmdProfile& profile);

/// The same horizontal view on a picture of width x height square pixels: above and below are widened or cut
/// in proportion. What an image of another shape than the panel's shows; sizes stay true.
FieldOfView fitToPicture(const FieldOfView& view, int width, int height);

}  // namespace coherency
