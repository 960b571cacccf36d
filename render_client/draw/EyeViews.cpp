#include "render_client/draw/EyeViews.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "common/body/Rig.h"

namespace coherency {
namespace {

const EyeDisplay& displayOf(const HmdProfile& hmd, Eye eye) {
  return eye == Eye::Left ? hmd.left : hmd.right;
}

FieldOfView viewOf(const HmdProfile& hmd, Eye eye, int width, int height) {
  if (eye == Eye::Mono) return fitToPicture(monoView(hmd), hmd.panel, width, height);
  const EyeDisplay& display = displayOf(hmd, eye);
  return display.lens ? display.view : fitToPicture(display.view, hmd.panel, width, height);
}

/// Tangent of an angle that a display turned by `yaw` towards its side adds to.
double turned(double tangent, double yaw) {
  return std::tan(std::atan(tangent) + yaw);
}

/// Text stands within what both eyes see, a little inside its corner, as if it were 2 m ahead: at the border
/// of an eye's picture the other eye might not see it, and two eyes could not see it as one. A lens is round:
/// it shows no corners, and its border not well.
void placeText(EyeView& view, const HmdProfile& hmd, Eye eye, double eye_distance) {
  constexpr double kAhead = 2.0;
  const double inside = hmd.left.lens ? 0.2 : 0.1;  // of what both see
  const FieldOfView left = viewOf(hmd, Eye::Left, view.width, view.height);
  const FieldOfView right = viewOf(hmd, Eye::Right, view.width, view.height);
  const double to_left =
      std::min(turned(left.tan_left, hmd.left.axis.yaw), turned(right.tan_left, hmd.right.axis.yaw));
  const double both = to_left + std::min(turned(left.tan_right, -hmd.left.axis.yaw),
                                         turned(right.tan_right, -hmd.right.axis.yaw));
  const double top =
      (hmd.left.lens ? 1.0 - 2.0 * inside : 1.0 - inside) * std::min(left.tan_up, right.tan_up);
  const Coord3 corner = kAhead * Coord3{inside * both - to_left, top, -1.0};
  const Coord3 p_head_eye{(eye == Eye::Left ? -0.5 : 0.5) * eye_distance, 0.0, 0.0};
  view.t_eye_head = rotation(displayOf(hmd, eye).axis).rigidInverse();
  const PixelPoint begin = projectToPixels(view.view, corner - p_head_eye, view.width, view.height);
  view.text_x = begin.x;
  view.text_y = begin.y;
  view.text_width = (1.0 - 2.0 * inside) * both * view.width / (view.view.tan_left + view.view.tan_right);
}

/// From the screen to the body whose rig it is; `scale` is the body's.
TransformMatrix bodyToScreen(const Screen& screen, const Rig& rig, double scale) {
  const Coord3 eyes = neutralHead(rig) + Coord3{0.0, rig.eye_up, -rig.eye_forward};
  const Coord3 middle = eyes + scale * Coord3{0.0, screen.above_m, -screen.distance_m};
  return TransformMatrix::translation(middle) * TransformMatrix::rotationX(-screen.tilt_rad);
}

/// The eye looks along the screen's axes, wherever the head is turned to.
void lookAtScreen(EyeView& view, const Scene& scene, Mode mode, const Screen& screen) {
  const bool is_robot = mode == Mode::Robot && scene.robot() != nullptr;
  const double scale = is_robot ? scene.human().rig().robot_scale : 1.0;
  const Rig& rig = is_robot ? scene.robot()->rig() : scene.human().rig();
  const TransformMatrix t_world_screen = vehicle(scene, mode) * bodyToScreen(screen, rig, scale);
  Coord3 eye = t_world_screen.rigidInverse().point(view.t_world_eye.origin());
  eye.z = std::max(eye.z, scale * kNearestToScreen);
  const double width = scale * screen.width_m;
  view.view = viewOfScreen(eye, width, width * view.height / view.width);
  view.t_world_eye = t_world_screen * TransformMatrix::translation(eye);
}

EyeView eyeView(const Scene& scene, Mode mode, const HmdProfile& hmd, Eye eye, int width, int height) {
  EyeView result;
  result.t_world_eye = scene.eye(eye, mode).globalTransform();
  result.near_m = hmd.near_m;
  result.width = width;
  result.height = height;
  result.t_world_vehicle = vehicle(scene, mode);
  result.t_world_other_vehicle = otherVehicle(scene, mode);
  if (hmd.screen) {
    lookAtScreen(result, scene, mode, *hmd.screen);
    return result;
  }
  result.view = viewOf(hmd, eye, width, height);
  if (eye == Eye::Mono) return result;
  result.t_world_eye = result.t_world_eye * rotation(displayOf(hmd, eye).axis);
  placeText(result, hmd, eye, scene.human().rig().eye_distance);
  return result;
}

double pixelsOfTangent(const EyeView& view) {
  return std::max(view.width / (view.view.tan_left + view.view.tan_right),
                  view.height / (view.view.tan_down + view.view.tan_up));
}

CyclopeanEye cyclopeanEye(const EyeView& left, const EyeView& right) {
  const Coord3 apart = right.t_world_eye.origin() - left.t_world_eye.origin();
  return {left.t_world_eye.origin() + 0.5 * apart, 0.5 * norm(apart),
          std::max(pixelsOfTangent(left), pixelsOfTangent(right))};
}

}  // namespace

EyeChoice eyeChoice(std::string_view name) {
  if (name == "left") return EyeChoice::Left;
  if (name == "right") return EyeChoice::Right;
  if (name == "both") return EyeChoice::Both;
  assert(name == "mono");
  return EyeChoice::Mono;
}

bool hasLens(const HmdProfile& hmd, EyeChoice eyes) {
  return eyes != EyeChoice::Mono && !hmd.screen && (hmd.left.lens || hmd.right.lens);
}

TransformMatrix vehicle(const Scene& scene, Mode mode) {
  if (mode == Mode::Robot && scene.robot() != nullptr) return scene.robot()->globalTransform();
  return scene.human().globalTransform();
}

std::optional<TransformMatrix> otherVehicle(const Scene& scene, Mode mode) {
  if (scene.robot() == nullptr) return std::nullopt;
  return vehicle(scene, mode == Mode::Robot ? Mode::Operator : Mode::Robot);
}

void eyeViews(const Scene& scene, Mode mode, const HmdProfile& hmd, EyeChoice choice, int width, int height,
              std::vector<EyeView>& views) {
  views.clear();
  if (choice == EyeChoice::Mono) {
    views.push_back(eyeView(scene, mode, hmd, Eye::Mono, width, height));
    views.back().cyclopean = cyclopeanEye(views.back(), views.back());
    return;
  }
  EyeView left = eyeView(scene, mode, hmd, Eye::Left, width, height);
  EyeView right = eyeView(scene, mode, hmd, Eye::Right, width, height);
  left.cyclopean = right.cyclopean = cyclopeanEye(left, right);
  if (choice != EyeChoice::Right) views.push_back(left);
  if (choice != EyeChoice::Left) {
    views.push_back(right);
    if (choice == EyeChoice::Both) views.back().x = width;
  }
}

}  // namespace coherency
