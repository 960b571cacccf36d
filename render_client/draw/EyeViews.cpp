#include "render_client/draw/EyeViews.h"

#include <algorithm>
#include <cassert>

namespace coherency {
namespace {

double eyeDistance(const Scene& scene) {
  return norm(scene.eye(Eye::Right, Mode::Operator).globalTransform().origin() -
              scene.eye(Eye::Left, Mode::Operator).globalTransform().origin());
}

/// Text stands within what both eyes see, a little inside its corner, as if it were 2 m ahead: at the border
/// of an eye's picture the other eye might not see it, and two eyes could not see it as one.
void placeText(EyeView& view, const HmdProfile& hmd, Eye eye, double eye_distance) {
  constexpr double kAhead = 2.0;
  constexpr double kInside = 0.1;  // of what both see
  const FieldOfView left = fitToPicture(hmd.left, view.width, view.height);
  const FieldOfView right = fitToPicture(hmd.right, view.width, view.height);
  const double to_left = std::min(left.tan_left, right.tan_left);
  const double both = to_left + std::min(left.tan_right, right.tan_right);
  const double to_top = std::min(left.tan_up, right.tan_up);
  const double parallax = (eye == Eye::Left ? 0.5 : -0.5) * eye_distance / kAhead;
  const double pixels = view.width / (view.view.tan_left + view.view.tan_right);  // of a tangent of 1
  view.text_x = pixels * (view.view.tan_left - to_left + kInside * both + parallax);
  view.text_y = pixels * (view.view.tan_up - (1.0 - kInside) * to_top);
  view.text_width = pixels * (1.0 - 2.0 * kInside) * both;
}

EyeView eyeView(const Scene& scene, Mode mode, const HmdProfile& hmd, Eye eye, int width, int height) {
  const FieldOfView view = eye == Eye::Left ? hmd.left : eye == Eye::Right ? hmd.right : monoView(hmd);
  EyeView result;
  result.t_world_eye = scene.eye(eye, mode).globalTransform();
  result.view = fitToPicture(view, width, height);
  result.near_m = hmd.near_m;
  result.width = width;
  result.height = height;
  if (eye != Eye::Mono) placeText(result, hmd, eye, eyeDistance(scene));
  result.t_world_vehicle = vehicle(scene, mode);
  result.t_world_other_vehicle = otherVehicle(scene, mode);
  return result;
}

}  // namespace

EyeChoice eyeChoice(std::string_view name) {
  if (name == "left") return EyeChoice::Left;
  if (name == "right") return EyeChoice::Right;
  if (name == "both") return EyeChoice::Both;
  assert(name == "mono");
  return EyeChoice::Mono;
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
    return;
  }
  if (choice != EyeChoice::Right) views.push_back(eyeView(scene, mode, hmd, Eye::Left, width, height));
  if (choice != EyeChoice::Left) {
    views.push_back(eyeView(scene, mode, hmd, Eye::Right, width, height));
    if (choice == EyeChoice::Both) views.back().x = width;
  }
}

}  // namespace coherency
