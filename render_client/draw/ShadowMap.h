#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "common/world/Scene.h"
#include "render_client/compile/CompiledScene.h"
#include "render_client/draw/DrawCommands.h"
#include "render_client/draw/GlObjects.h"
#include "render_client/draw/SceneBuffers.h"

namespace coherency {

/// Which points of the scene a light reaches: depth as seen from the light looking straight down, 127 degrees
/// wide and high. What lies outside is taken as lit. Things that shine by themselves (emission of a half or
/// more) cast no shadow, nor does what is within 0.1 m of the light, so a lamp may stand inside its own
/// fitting.
class ShadowMap {
 public:
  ShadowMap(int resolution, std::size_t drawable_count);

  void render(const CompiledScene& scene, const SceneBuffers& buffers, const Light& light);

  /// Clip coordinates of the map from eye coordinates, after render().
  glm::mat4 clipFromEye(const TransformMatrix& t_world_eye) const;
  /// A texel's width at 1 m below the light, m.
  float texelAtOneMetre() const;
  /// A texel's width as a share of the map's.
  float texelShare() const { return 1.0F / static_cast<float>(resolution_); }
  void bindTexture() const { glBindTextureUnit(0, depth_.name()); }

 private:
  void fill(const CompiledScene& scene);

  int resolution_;
  Texture depth_;
  Framebuffer frame_;
  Program program_;
  Buffer matrices_buffer_;
  std::vector<glm::mat4> matrices_;
  DrawCommands commands_;
  TransformMatrix t_world_light_;
  TransformMatrix projection_;
};

}  // namespace coherency
