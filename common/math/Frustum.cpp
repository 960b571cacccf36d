#include "common/math/Frustum.h"

#include <cassert>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "common/math/FixedPoint.h"

namespace coherency {
namespace {

double tangentOfDegrees(double degrees, const char* side) {
  if (!(degrees > -90.0 && degrees < 90.0)) {
    std::ostringstream text;
    text << "field of view: angle " << side << " is " << degrees
         << " degrees; it must lie between -90 and 90";
    throw std::domain_error(text.str());
  }
  return std::tan(degrees * (kTurn / 360.0));
}

void checkExtent(double low, double high, const char* sides) {
  if (!std::isfinite(low) || !std::isfinite(high) || !(low + high > 0.0)) {
    std::ostringstream text;
    text << "field of view: tangents " << sides << " are " << low << " and " << high
         << "; their sum must be finite and above zero, or the image is empty";
    throw std::domain_error(text.str());
  }
}

void check(const FieldOfView& view) {
  checkExtent(view.tan_left, view.tan_right, "left and right");
  checkExtent(view.tan_down, view.tan_up, "down and up");
}

}  // namespace

FieldOfView fieldOfViewFromDegrees(double left, double right, double down, double up) {
  const FieldOfView view{tangentOfDegrees(left, "left"), tangentOfDegrees(right, "right"),
                         tangentOfDegrees(down, "down"), tangentOfDegrees(up, "up")};
  check(view);
  return view;
}

FieldOfView viewOfScreen(const Coord3& eye, double width, double height) {
  assert(eye.z > 0.0);
  return {(0.5 * width + eye.x) / eye.z, (0.5 * width - eye.x) / eye.z, (0.5 * height + eye.y) / eye.z,
          (0.5 * height - eye.y) / eye.z};
}

TransformMatrix projection(const FieldOfView& view, double near_m) {
  check(view);
  if (!(near_m > 0.0) || !std::isfinite(near_m)) {
    std::ostringstream text;
    text << "projection: near plane at " << near_m << " m; it must be finite and above zero";
    throw std::domain_error(text.str());
  }
  const double width = view.tan_left + view.tan_right;
  const double height = view.tan_down + view.tan_up;
  TransformMatrix p;
  p(0, 0) = 2.0 / width;
  p(0, 2) = (view.tan_right - view.tan_left) / width;
  p(1, 1) = 2.0 / height;
  p(1, 2) = (view.tan_up - view.tan_down) / height;
  p(2, 2) = 0.0;
  p(2, 3) = near_m;
  p(3, 2) = -1.0;
  p(3, 3) = 0.0;
  return p;
}

PixelPoint projectToPixels(const FieldOfView& view, const Coord3& p_eye, int width, int height) {
  assert(p_eye.z < 0.0);
  const double across = p_eye.x / -p_eye.z;
  const double up = p_eye.y / -p_eye.z;
  return {width * (across + view.tan_left) / (view.tan_left + view.tan_right),
          height * (view.tan_up - up) / (view.tan_down + view.tan_up)};
}

}  // namespace coherency
