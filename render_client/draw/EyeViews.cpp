#include "render_client/draw/EyeViews.h"

#include <cassert>

namespace coherency {
namespace {

EyeView eyeView(const Scene& scene, Mode mode, const HmdProfile& hmd, Eye eye, int width, int height) {
  const FieldOfView view = eye == Eye::Left ? hmd.left : eye == Eye::Right ? hmd.right : monoView(hmd);
  EyeView result;
  result.t_world_eye = scene.eye(eye, mode).globalTransform();
  result.view = fitToPicture(view, width, height);
  result.near_m = hmd.near_m;
  result.width = width;
  result.height = height;
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
