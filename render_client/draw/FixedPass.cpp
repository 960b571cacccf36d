#include "render_client/draw/FixedPass.h"

#include "render_client/draw/ShaderProgram.h"
#include "render_client/draw/ShaderSources.h"

namespace coherency {
namespace {

std::vector<Sphere> worldSpheres(const CompiledScene& scene) {
  std::vector<Sphere> spheres;
  for (const Drawable& drawable : scene.fixed().drawables) spheres.push_back(scene.worldSphere(drawable));
  return spheres;
}

}  // namespace

FixedPass::FixedPass(const CompiledScene& scene, int shadow_resolution)
    : plain_program_(makeProgram("fixed", fixedVertexShader({}), fragmentShader({}))),
      shaded_program_(makeProgram("fixed, in shadow",
                                  fixedVertexShader({.shadow_resolution = shadow_resolution}),
                                  fragmentShader({.shadow_resolution = shadow_resolution}))),
      plain_(scene.fixed().drawables.size()),
      shaded_(scene.fixed().drawables.size()),
      spheres_(worldSpheres(scene)),
      order_(scene.fixed().drawables.size()),
      objects_(scene.fixed().drawables.size()),
      object_buffer_(GL_SHADER_STORAGE_BUFFER, objects_.size() * sizeof(Object)) {
  for (const Drawable& drawable : scene.fixed().drawables) boxes_.push_back(worldBox(scene, drawable));
}

void FixedPass::begin(const CompiledScene& scene, const Coord3& eye, std::size_t view_count,
                      const ViewPyramids& views, const OverheadShadow* shadow) {
  object_buffer_.reserve(view_count);
  seen_.clear();
  spheres_.findSeen(views, seen_);
  order_.clear();
  for (const std::uint32_t i : seen_) order_.add(i, farthest(boxes_[i], eye));
  order_.sort();
  plain_.clear();
  shaded_.clear();
  for (const NearestFirst::Shown& shown : order_.shown()) {
    const Drawable& drawable = scene.fixed().drawables[shown.number];
    const bool in_shadow = shadow != nullptr && drawable.shaded && shadow->reaches(boxes_[shown.number]);
    (in_shadow ? shaded_ : plain_).add(drawable, shown.number, false);
  }
  plain_.upload();
  shaded_.upload();
}

void FixedPass::draw(std::size_t slot, const Coord3& eye, const CompiledScene& scene,
                     const SceneBuffers& buffers) {
  for (const std::uint32_t i : seen_) {
    const Drawable& drawable = scene.fixed().drawables[i];
    const Material& material = drawable.faces->material;
    objects_[i] = {glm::vec4(glm::dvec4((drawable.origin - eye).glm(), material.emission)),
                   glm::vec4(glm::dvec4(material.colour.glm(), 0.0))};
  }
  object_buffer_.write(slot, objects_.data(), objects_.size() * sizeof(Object));
  object_buffer_.bind(slot, 0);
  buffers.bindFixed();
  glUseProgram(shaded_program_.name());
  shaded_.draw();
  glUseProgram(plain_program_.name());
  plain_.draw();
}

}  // namespace coherency
