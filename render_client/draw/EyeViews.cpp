#include "render_client/draw/EyeViews.h"

#include <cassert>

namespace coherency {
namespace {

EyeView eyeView(const Scene& scene, const HmdProfile& hmd, Eye eye, int width, int height) {
  const FieldOfView view = eye == Eye::Left ? hmd.left : eye == Eye::Right ? hmd.right : monoView(hmd);
  EyeView result;
  result.t_world_eye = scene.human().eye(eye).globalTransform();
  result.view = fitToPicture(view, width, height);
  result.near_m = hmd.near_m;
  result.width = width;
  result.height = height;
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

void eyeViews(const Scene& scene, const HmdProfile& hmd, EyeChoice choice, int width, int height,
              std::vector<EyeView>& views) {
  views.clear();
  if (choice == EyeChoice::Mono) {
    views.push_back(eyeView(scene, hmd, Eye::Mono, width, height));
    return;
  }
  if (choice != EyeChoice::Right) views.push_back(eyeView(scene, hmd, Eye::Left, width, height));
  if (choice != EyeChoice::Left) {
    views.push_back(eyeView(scene, hmd, Eye::Right, width, height));
    if (choice == EyeChoice::Both) views.back().x = width;
  }
}

}  // namespace coherency
