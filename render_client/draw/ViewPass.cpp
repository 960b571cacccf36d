#include "render_client/draw/ViewPass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render_client/draw/EyeSpace.h"
#include "render_client/draw/ShaderProgram.h"
#include "render_client/draw/ShaderSources.h"

namespace coherency {
namespace {

constexpr double kFlat = 1e-9;  ///< handedness below which an object is taken as squashed flat and not drawn

std::size_t roundUp(std::size_t size, GLenum alignment_name) {
  GLint alignment = 1;
  glGetIntegerv(alignment_name, &alignment);
  const auto step = static_cast<std::size_t>(alignment);
  return std::max<std::size_t>((size + step - 1) / step, 1) * step;
}

glm::vec4 vec4(const Coord3& v, double w = 0.0) {
  return {glm::dvec4(v.glm(), w)};
}

/// From `eye` to the axis-parallel box about the object's box, in the world.
double distanceToBox(const TransformMatrix& t_world_object, const Drawable& drawable, const Coord3& eye) {
  const glm::dmat3 m(t_world_object.glm());
  const glm::dvec3 half = drawable.half_extent.glm();
  const glm::dvec3 reach = glm::abs(m[0]) * half.x + glm::abs(m[1]) * half.y + glm::abs(m[2]) * half.z;
  const glm::dvec3 away = glm::abs((eye - t_world_object.point(drawable.origin)).glm()) - reach;
  return glm::length(glm::max(away, glm::dvec3(0.0)));
}

/// As the shader has it (std140).
struct ViewBlock {
  glm::mat4 clip_from_eye;
  glm::mat4 shadow_from_eye{1.0F};
  glm::vec4 up;
  glm::vec4 sky;
  glm::vec4 ground;
  glm::vec4 shadow{0.0F};
  std::array<glm::vec4, kMaxLights> light_position{};
  std::array<glm::vec4, kMaxLights> light_colour{};
};

}  // namespace

ViewPass::ViewPass(std::size_t drawable_count, std::size_t light_count, bool shadows)
    : program_(makeProgram("scene", sceneVertexShader(std::min(light_count, kMaxLights), shadows).c_str(),
                           sceneFragmentShader(std::min(light_count, kMaxLights), shadows).c_str())),
      commands_(drawable_count),
      objects_(drawable_count),
      object_stride_(roundUp(drawable_count * sizeof(Object), GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT)),
      view_stride_(roundUp(sizeof(ViewBlock), GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT)) {
  shown_.reserve(drawable_count);
}

void ViewPass::makeRoom(std::size_t view_count) {
  if (view_count <= room_) return;
  room_ = view_count;
  glNamedBufferData(object_buffer_.name(), static_cast<GLsizeiptr>(room_ * object_stride_), nullptr,
                    GL_STREAM_DRAW);
  glNamedBufferData(view_buffer_.name(), static_cast<GLsizeiptr>(room_ * view_stride_), nullptr,
                    GL_STREAM_DRAW);
}

void ViewPass::begin(const CompiledScene& scene, const Coord3& eye, std::size_t view_count) {
  makeRoom(view_count);
  shown_.clear();
  for (std::size_t i = 0; i < scene.drawables().size(); ++i) {
    const Drawable& drawable = scene.drawables()[i];
    const TransformMatrix& t_world_object = scene.worldTransform(drawable);
    const double hand = handedness(t_world_object);
    if (std::abs(hand) < kFlat) continue;
    shown_.push_back({i, distanceToBox(t_world_object, drawable, eye), hand < 0.0});
  }
  std::sort(shown_.begin(), shown_.end(),
            [](const Shown& a, const Shown& b) { return a.distance < b.distance; });
  commands_.clear();
  for (const Shown& s : shown_)
    commands_.add(scene.drawables()[s.drawable], DrawCommands::Triangles::Lit, s.drawable, s.mirrored);
  commands_.upload();
}

void ViewPass::uploadObjects(std::size_t slot, const EyeView& view, const CompiledScene& compiled) {
  for (const Shown& s : shown_) {
    const std::size_t i = s.drawable;
    const Drawable& drawable = compiled.drawables()[i];
    const glm::dmat4 t_eye_mesh =
        eyeFromMesh(view.t_world_eye, compiled.worldTransform(drawable), drawable.origin);
    const glm::dmat3 normals = normalMatrix(glm::dmat3(t_eye_mesh));
    const Material& material = drawable.faces->material;
    objects_[i] = {glm::mat4(t_eye_mesh),
                   {glm::dvec4(normals[0], material.emission)},
                   {glm::dvec4(normals[1], 0.0)},
                   {glm::dvec4(normals[2], 0.0)},
                   vec4(material.colour, material.gloss)};
  }
  glNamedBufferSubData(object_buffer_.name(), static_cast<GLintptr>(slot * object_stride_),
                       static_cast<GLsizeiptr>(objects_.size() * sizeof(Object)), objects_.data());
}

void ViewPass::uploadView(std::size_t slot, const EyeView& view, const Scene& scene,
                          const ShadowMap* shadow) {
  const TransformMatrix r_eye_world = view.t_world_eye.linear().rigidInverse();
  ViewBlock block;
  block.clip_from_eye = glm::mat4(projection(view.view, view.near_m).glm());
  block.up = vec4(r_eye_world.vector({0.0, 1.0, 0.0}));
  block.sky = vec4(scene.skyLight());
  block.ground = vec4(scene.groundLight());
  const std::size_t lights = std::min(scene.lights().size(), kMaxLights);
  for (std::size_t i = 0; i < lights; ++i) {
    const Light& light = scene.lights()[i];
    block.light_position[i] = vec4(r_eye_world.vector(light.position - view.t_world_eye.origin()));
    block.light_colour[i] = vec4(light.colour * light.intensity);
  }
  if (shadow != nullptr) {
    block.shadow_from_eye = shadow->clipFromEye(view.t_world_eye);
    block.shadow = {shadow->texelAtOneMetre(), shadow->texelShare(), 0.0F, 0.0F};
  }
  glNamedBufferSubData(view_buffer_.name(), static_cast<GLintptr>(slot * view_stride_), sizeof(ViewBlock),
                       &block);
}

void ViewPass::draw(std::size_t slot, const EyeView& view, const Scene& scene, const CompiledScene& compiled,
                    const SceneBuffers& buffers, const ShadowMap* shadow) {
  uploadObjects(slot, view, compiled);
  uploadView(slot, view, scene, shadow);
  glViewport(view.x, view.y, view.width, view.height);
  glUseProgram(program_.name());
  glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, object_buffer_.name(),
                    static_cast<GLintptr>(slot * object_stride_), static_cast<GLsizeiptr>(object_stride_));
  glBindBufferRange(GL_UNIFORM_BUFFER, 0, view_buffer_.name(), static_cast<GLintptr>(slot * view_stride_),
                    sizeof(ViewBlock));
  if (shadow != nullptr) shadow->bindTexture();
  buffers.bind();
  commands_.draw();
}

}  // namespace coherency
