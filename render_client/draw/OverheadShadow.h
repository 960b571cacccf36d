#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "render_client/draw/DrawCommands.h"
#include "render_client/draw/GlObjects.h"
#include "render_client/draw/SceneBuffers.h"
#include "render_client/draw/WorldBox.h"

namespace coherency {

/// Shadows of what moves, as under a wide lamp overhead, a little to one side (kShadowLean): they show how
/// high above a table a hand is. A map of heights as seen along that light, 4 m wide on the floor and up to
/// 4 m above it, that goes with the vehicle one drives, in steps of its texels, so that shadows neither crawl
/// nor jump; they fade towards its border. Only what moves casts; what it casts on may move or not.
class OverheadShadow {
 public:
  /// Throws std::runtime_error where the driver has no such resolution. `moving_count`: of drawables.
  OverheadShadow(int resolution, std::size_t moving_count);

  /// Draws the map for a vehicle that stands there; -z is ahead of it.
  void render(const CompiledScene& scene, const SceneBuffers& buffers,
              const TransformMatrix& t_world_vehicle);

  /// After render(): whether what never moves and is in the box may be in a shadow.
  bool reaches(const WorldBox& box) const;
  /// After render(): takes points in the world's axes from `eye` to u, v and height in the map, each 0..1.
  glm::mat4 mappingFrom(const Coord3& eye) const;
  void bindTexture() const { glBindTextureUnit(0, depth_.name()); }

 private:
  void chooseCasters(const CompiledScene& scene);
  void addCaster(const CompiledScene& scene, std::size_t number, const WorldBox& box);

  int resolution_;
  Texture depth_;
  Framebuffer frame_;
  Program program_;
  Buffer matrices_buffer_;
  std::vector<glm::mat4> matrices_;
  DrawCommands commands_;
  Coord3 corner_;  ///< where u, v and height are 0
  Coord3 floor_middle_;
  std::vector<WorldBox> casters_;
};

}  // namespace coherency
