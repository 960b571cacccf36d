#include "render_client/draw/ShadowMap.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <string>

#include "common/math/Frustum.h"
#include "render_client/draw/EyeSpace.h"
#include "render_client/draw/ShaderProgram.h"
#include "render_client/draw/ShaderSources.h"

namespace coherency {
namespace {

constexpr double kTangent = 2.0;
constexpr double kNear = 0.1;
constexpr double kShines = 0.5;
constexpr double kFlat = 1e-9;

/// Floor, walls and ceiling, and the world outside: they surround what casts shadows and only receive them.
/// They would fill the whole map.
bool isShell(const Drawable& drawable, const TransformMatrix& t_world_object) {
  constexpr double kShell = 4.0;  // m
  const Coord3& half = drawable.half_extent;
  return 2.0 * std::max({half.x, half.y, half.z}) * t_world_object.maxScale() > kShell;
}

int checkedResolution(int resolution) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (resolution < 16 || resolution > limit)
    throw std::runtime_error("shadow resolution " + std::to_string(resolution) + " must be 16 to " +
                             std::to_string(limit) + " with this driver");
  return resolution;
}

}  // namespace

ShadowMap::ShadowMap(int resolution, std::size_t drawable_count)
    : resolution_(checkedResolution(resolution)),
      program_(makeProgram("shadow", kShadowVertexShader, kShadowFragmentShader)),
      matrices_(std::max<std::size_t>(drawable_count, 1)),
      commands_(drawable_count),
      projection_(projection({kTangent, kTangent, kTangent, kTangent}, kNear)) {
  const GLuint texture = depth_.name();
  glTextureStorage2D(texture, 1, GL_DEPTH_COMPONENT32F, resolution, resolution);
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  const float infinitely_far[4] = {0.0F, 0.0F, 0.0F, 0.0F};  // outside the map nothing is in shadow
  glTextureParameterfv(texture, GL_TEXTURE_BORDER_COLOR, infinitely_far);
  glTextureParameteri(texture, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTextureParameteri(texture, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
  glNamedFramebufferTexture(frame_.name(), GL_DEPTH_ATTACHMENT, texture, 0);
  glNamedFramebufferDrawBuffer(frame_.name(), GL_NONE);
  glNamedFramebufferReadBuffer(frame_.name(), GL_NONE);
  glNamedBufferStorage(matrices_buffer_.name(), static_cast<GLsizeiptr>(matrices_.size() * sizeof(glm::mat4)),
                       nullptr, GL_DYNAMIC_STORAGE_BIT);
}

void ShadowMap::fill(const CompiledScene& scene) {
  commands_.clear();
  for (std::size_t i = 0; i < scene.drawables().size(); ++i) {
    const Drawable& drawable = scene.drawables()[i];
    const TransformMatrix& t_world_object = scene.worldTransform(drawable);
    const double hand = handedness(t_world_object);
    if (drawable.faces->material.emission >= kShines || std::abs(hand) < kFlat ||
        isShell(drawable, t_world_object))
      continue;
    matrices_[i] =
        glm::mat4(projection_.glm() * eyeFromMesh(t_world_light_, t_world_object, drawable.origin));
    commands_.add(drawable, DrawCommands::Triangles::Plain, i, hand < 0.0);
  }
  commands_.upload();
  glNamedBufferSubData(matrices_buffer_.name(), 0,
                       static_cast<GLsizeiptr>(matrices_.size() * sizeof(glm::mat4)), matrices_.data());
}

void ShadowMap::render(const CompiledScene& scene, const SceneBuffers& buffers, const Light& light) {
  t_world_light_ =
      TransformMatrix::translation(light.position) * TransformMatrix::rotationX(-0.5 * std::numbers::pi);
  fill(scene);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glViewport(0, 0, resolution_, resolution_);
  glClear(GL_DEPTH_BUFFER_BIT);
  glUseProgram(program_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, matrices_buffer_.name());
  buffers.bind();
  commands_.draw();
}

glm::mat4 ShadowMap::clipFromEye(const TransformMatrix& t_world_eye) const {
  return glm::mat4(projection_.glm() * eyeFromMesh(t_world_light_, t_world_eye, {}));
}

float ShadowMap::texelAtOneMetre() const {
  return static_cast<float>(2.0 * kTangent / resolution_);
}

}  // namespace coherency
