#include "render_client/draw/ViewUniforms.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace coherency {
namespace {

/// As the shaders have it (std140).
struct Shared {
  glm::mat4 clip_from_world;
  glm::mat4 shadow_from_world{0.0F};
  glm::vec4 to_second_tile{0.0F};
  glm::vec4 sky;
  glm::vec4 ground;
};

glm::vec3 vec3(const Coord3& v) {
  return glm::vec3(v.glm());
}

}  // namespace

ViewUniforms::ViewUniforms() : buffer_(GL_UNIFORM_BUFFER, sizeof(Shared)) {}

void ViewUniforms::write(std::size_t slot, const EyeView& view, const Ambient& ambient,
                         const OverheadShadow* shadow) {
  const Coord3 eye = view.t_world_eye.origin();
  Shared block;
  block.clip_from_world =
      glm::mat4(projection(view.view, view.near_m).glm() * view.t_world_eye.linear().rigidInverse().glm());
  block.sky = glm::vec4(vec3(ambient.sky), 0.0F);
  block.ground = glm::vec4(vec3(ambient.ground), 0.0F);
  if (shadow != nullptr) {
    block.shadow_from_world = shadow->mappingFrom(eye);
    block.to_second_tile = glm::vec4(shadow->toSecondTile(), 0.0F);
  }
  buffer_.write(slot, &block, sizeof(block));
}

}  // namespace coherency
