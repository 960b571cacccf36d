#include "render_client/draw/ViewUniforms.h"

#include <cstring>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace coherency {
namespace {

/// As the shaders have it (std140).
struct Shared {
  glm::mat4 clip_from_world;
  glm::mat4 shadow_from_world{0.0F};
  glm::vec4 to_second_tile{0.0F};
  glm::vec4 eye;
  glm::vec4 sky;
  glm::vec4 ground;
};

glm::vec4 vec4(const Coord3& v) {
  return glm::vec4(glm::dvec4(v.glm(), 0.0));
}

/// From coordinates near the eye: what is far away has been subtracted in double.
glm::mat4 clipFrom(const Coord3& origin, const EyeView& view) {
  TransformMatrix t_origin_eye = view.t_world_eye;
  t_origin_eye.setOrigin(view.t_world_eye.origin() - origin);
  return glm::mat4(projection(view.view, view.near_m).glm() * t_origin_eye.rigidInverse().glm());
}

}  // namespace

void ViewUniforms::write(std::span<const EyeView> views, const Coord3& origin, const Ambient& ambient,
                         const OverheadShadow* shadow) {
  if (views.size() > room_) {
    room_ = views.size();
    stride_ = alignedForBinding(sizeof(Shared));
    buffer_.emplace(room_ * stride_);
  }
  auto* to = buffer_->next<std::byte>();
  for (const EyeView& view : views) {
    Shared shared;
    shared.clip_from_world = clipFrom(origin, view);
    shared.eye = vec4(view.t_world_eye.origin() - origin);
    shared.sky = vec4(ambient.sky);
    shared.ground = vec4(ambient.ground);
    if (shadow != nullptr) {
      shared.shadow_from_world = shadow->mappingFrom(origin);
      shared.to_second_tile = glm::vec4(shadow->toSecondTile(), 0.0F);
    }
    std::memcpy(to, &shared, sizeof(shared));
    to += stride_;
  }
}

void ViewUniforms::bind(std::size_t view) const {
  buffer_->bind(GL_UNIFORM_BUFFER, 0, view * stride_, sizeof(Shared));
}

}  // namespace coherency
