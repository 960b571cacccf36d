#pragma once

#include <vector>

#include <glm/vec4.hpp>

#include "render_client/cull/SphereTree.h"
#include "render_client/draw/DrawCommands.h"
#include "render_client/draw/NearestFirst.h"
#include "render_client/draw/OverheadShadow.h"
#include "render_client/draw/SlottedBuffer.h"

namespace coherency {

/// Draws what never moves: its light lies at its vertices. Only what something that moves may cast a shadow
/// on is drawn with a shader that looks for it in every pixel.
class FixedPass {
 public:
  /// `shadow_resolution`: texels a side of the map; 0: no shadows.
  FixedPass(const CompiledScene& scene, int shadow_resolution);

  /// Chooses what is drawn in this frame, by all its views: what one of them may see. `shadow` may be null.
  void begin(const CompiledScene& scene, const Coord3& eye, std::size_t view_count, const ViewPyramids& views,
             const OverheadShadow* shadow);
  /// Draws view number `slot` of the frame, whose uniforms are bound, into the bound framebuffer.
  void draw(std::size_t slot, const Coord3& eye, const CompiledScene& scene, const SceneBuffers& buffers);

  std::size_t shadedCount() const { return shaded_.size(); }  ///< drawables, in this frame
  std::size_t plainCount() const { return plain_.size(); }

 private:
  /// As the shader has it (std430).
  struct Object {
    glm::vec4 offset_emission;
    glm::vec4 colour;
  };

  Program plain_program_;
  Program shaded_program_;
  DrawCommands plain_;
  DrawCommands shaded_;
  SphereTree spheres_;
  std::vector<std::uint32_t> seen_;
  NearestFirst order_;
  std::vector<WorldBox> boxes_;
  std::vector<Object> objects_;
  SlottedBuffer object_buffer_;
};

}  // namespace coherency
