#include "render_client/draw/OverheadShadow.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <glm/common.hpp>

#include "render_client/compile/NormalMatrix.h"
#include "render_client/draw/ShaderProgram.h"
#include "render_client/draw/ShaderSources.h"

namespace coherency {
namespace {

constexpr double kWidth = 4.0;   // m
constexpr double kBelow = 1.0;   // m below the vehicle's floor
constexpr double kHeight = 5.0;  // m from there to the top
constexpr double kAhead = 0.7;   // m
constexpr double kSoft = 0.05;   // m, by which a shadow is wider than what casts it

/// u, v and height from metres in the world's axes. Seen from above v runs against z, so that fronts stay
/// fronts.
const glm::dmat4 kMapFromCorner({1.0 / kWidth, 0.0, 0.0, 0.0},
                                {kShadowLean.x / kWidth, -kShadowLean.y / kWidth, 1.0 / kHeight, 0.0},
                                {0.0, -1.0 / kWidth, 0.0, 0.0}, {0.0, 0.0, 0.0, 1.0});

/// A box with all that is in its shadow down to a height.
WorldBox withShadow(WorldBox box, double down_to) {
  const double fall = std::max(box.high.y - down_to, 0.0);
  const Coord3 lean = fall * Coord3{kShadowLean.x, 0.0, kShadowLean.y};
  box.low += Coord3{std::min(lean.x, 0.0), 0.0, std::min(lean.z, 0.0)};
  box.high += Coord3{std::max(lean.x, 0.0), 0.0, std::max(lean.z, 0.0)};
  return box;
}

int checkedResolution(int resolution) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (resolution < 16 || resolution > limit)
    throw std::runtime_error("shadow resolution " + std::to_string(resolution) + " must be 16 to " +
                             std::to_string(limit) + " with this driver");
  return resolution;
}

void makeMap(GLuint texture, int resolution) {
  glTextureStorage2D(texture, 1, GL_DEPTH_COMPONENT32F, resolution, resolution);
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTextureParameteri(texture, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
}

}  // namespace

OverheadShadow::OverheadShadow(int resolution, std::size_t moving_count)
    : resolution_(checkedResolution(resolution)),
      program_(makeProgram("shadow", kShadowVertexShader, kShadowFragmentShader)),
      matrices_(std::max<std::size_t>(moving_count, 1)),
      commands_(moving_count) {
  casters_.reserve(moving_count);
  makeMap(depth_.name(), resolution);
  glNamedFramebufferTexture(frame_.name(), GL_DEPTH_ATTACHMENT, depth_.name(), 0);
  glNamedFramebufferDrawBuffer(frame_.name(), GL_NONE);
  glNamedFramebufferReadBuffer(frame_.name(), GL_NONE);
  glNamedBufferStorage(matrices_buffer_.name(), static_cast<GLsizeiptr>(matrices_.size() * sizeof(glm::mat4)),
                       nullptr, GL_DYNAMIC_STORAGE_BIT);
}

void OverheadShadow::addCaster(const CompiledScene& scene, std::size_t number, const WorldBox& box) {
  const Drawable& drawable = scene.moving().drawables[number];
  const TransformMatrix& t_world_object = scene.worldTransform(drawable);
  const double hand = handedness(t_world_object);
  if (drawable.faces->material.emission >= kShines || std::abs(hand) < kFlat) return;
  const glm::dmat4 clip_from_map({2.0, 0.0, 0.0, 0.0}, {0.0, 2.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0},
                                 {-1.0, -1.0, 0.0, 1.0});
  matrices_[number] =
      glm::mat4(clip_from_map * kMapFromCorner * fromEye(corner_, t_world_object, drawable.origin));
  commands_.add(drawable, number, hand < 0.0);
  casters_.push_back(box);
}

void OverheadShadow::chooseCasters(const CompiledScene& scene) {
  const WorldBox region{floor_middle_ - Coord3{0.5 * kWidth, 0.0, 0.5 * kWidth},
                        floor_middle_ + Coord3{0.5 * kWidth, 0.0, 0.5 * kWidth}};
  commands_.clear();
  casters_.clear();
  for (std::size_t i = 0; i < scene.moving().drawables.size(); ++i) {
    const WorldBox box = worldBox(scene, scene.moving().drawables[i]);
    if (overlapFromAbove(withShadow(box, region.low.y), region)) addCaster(scene, i, box);
  }
  commands_.upload();
  glNamedBufferSubData(matrices_buffer_.name(), 0,
                       static_cast<GLsizeiptr>(matrices_.size() * sizeof(glm::mat4)), matrices_.data());
}

void OverheadShadow::render(const CompiledScene& scene, const SceneBuffers& buffers,
                            const TransformMatrix& t_world_vehicle) {
  const Coord3 middle = t_world_vehicle.point({0.0, 0.0, -kAhead});
  const double texel = kWidth / resolution_;
  floor_middle_ = {texel * std::round(middle.x / texel), middle.y, texel * std::round(middle.z / texel)};
  corner_ = floor_middle_ +
            Coord3{-0.5 * kWidth + kBelow * kShadowLean.x, -kBelow, 0.5 * kWidth + kBelow * kShadowLean.y};
  chooseCasters(scene);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glViewport(0, 0, resolution_, resolution_);
  glClear(GL_DEPTH_BUFFER_BIT);
  glUseProgram(program_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, matrices_buffer_.name());
  buffers.bindMoving();
  commands_.draw();
}

bool OverheadShadow::reaches(const WorldBox& box) const {
  const Coord3 soft{kSoft, 0.0, kSoft};
  return std::any_of(casters_.begin(), casters_.end(), [&](const WorldBox& caster) {
    return box.low.y < caster.high.y &&
           overlapFromAbove({box.low - soft, box.high + soft}, withShadow(caster, box.low.y));
  });
}

glm::mat4 OverheadShadow::mappingFrom(const Coord3& eye) const {
  return glm::mat4(kMapFromCorner * fromEye(corner_, TransformMatrix::translation(eye), {}));
}

}  // namespace coherency
