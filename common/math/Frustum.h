#pragma once

#include "common/math/Coord3.h"
#include "common/math/TransformMatrix.h"

namespace coherency {

struct Sphere {
  Coord3 centre;
  double radius = 0.0;
};

/// Field of view of one eye as tangents of the angles from the optical axis (-z); each grows outward from the
/// axis, so all four are positive where the axis lies inside the image. left + right and down + up must be >
/// 0.
struct FieldOfView {
  double tan_left = 1.0;
  double tan_right = 1.0;
  double tan_down = 1.0;
  double tan_up = 1.0;
};

/// Field of view from angles in degrees, each in (-90, 90); throws std::domain_error naming the one that is
/// not, or when the image would be empty.
FieldOfView fieldOfViewFromDegrees(double left, double right, double down, double up);

/// What an eye sees through a flat window or on a flat screen, `width` x `height`, whose middle is the origin
/// of the frame that `eye` is in, x right, y up, z towards the viewer (Kooima, Generalized perspective
/// projection, 2009). The view's axes are the screen's, whichever way the head is turned. Precondition: eye.z
/// > 0.
FieldOfView viewOfScreen(const Coord3& eye, double width, double height);

/// Perspective transform of an asymmetric view with reversed depth and the far plane at infinity: depth is 1
/// at `near_m` and falls to 0 at infinity (clip range 0..1, glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE)).
/// Throws std::domain_error for an empty view or near_m <= 0.
TransformMatrix projection(const FieldOfView& view, double near_m);

/// Pixel coordinates of an eye-frame point (origin at the picture's top left corner, x right, y down, pixel
/// centres at .5). Precondition: p_eye.z < 0.
struct PixelPoint {
  double x = 0.0;
  double y = 0.0;
};
PixelPoint projectToPixels(const FieldOfView& view, const Coord3& p_eye, int width, int height);

}  // namespace coherency
