#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "common/world/Scene.h"
#include "render_client/compile/CompiledScene.h"
#include "render_client/draw/DrawCommands.h"
#include "render_client/draw/EyeView.h"
#include "render_client/draw/GlObjects.h"
#include "render_client/draw/SceneBuffers.h"
#include "render_client/draw/ShadowMap.h"

namespace coherency {

/// Draws the scene as one eye sees it: composes every object's transform relative to the eye, hands them to
/// the GPU and draws all of them at once. Of the scene's lights the first 8 shine.
class ViewPass {
 public:
  /// `light_count` of the scene's lights, `shadows` of the first of them: fixed, so that the shader has no
  /// loops or branches (on a software renderer they cost ten times the arithmetic).
  ViewPass(std::size_t drawable_count, std::size_t light_count, bool shadows);

  /// Chooses what is drawn in this frame (by all its views), nearest to `eye` first so that what it hides is
  /// not shaded, and makes room for that many views.
  void begin(const CompiledScene& scene, const Coord3& eye, std::size_t view_count);
  /// Draws view number `slot` of the frame into the bound framebuffer. `shadow` may be null.
  void draw(std::size_t slot, const EyeView& view, const Scene& scene, const CompiledScene& compiled,
            const SceneBuffers& buffers, const ShadowMap* shadow);

 private:
  /// As the shader has it (std430).
  struct Object {
    glm::mat4 eye_from_mesh;
    glm::vec4 normal_x_emission;
    glm::vec4 normal_y;
    glm::vec4 normal_z;
    glm::vec4 colour_gloss;
  };

  struct Shown {
    std::size_t drawable;
    double distance;  ///< m, of its box from the eye
    bool mirrored;
  };

  void makeRoom(std::size_t view_count);
  void uploadObjects(std::size_t slot, const EyeView& view, const CompiledScene& compiled);
  void uploadView(std::size_t slot, const EyeView& view, const Scene& scene, const ShadowMap* shadow);

  Program program_;
  DrawCommands commands_;
  std::vector<Shown> shown_;
  std::vector<Object> objects_;
  std::size_t object_stride_;  ///< bytes a view's objects take
  std::size_t view_stride_;
  std::size_t room_ = 0;  ///< views the buffers hold
  Buffer object_buffer_;
  Buffer view_buffer_;
};

}  // namespace coherency
