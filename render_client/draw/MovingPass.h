#pragma once

#include <array>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "render_client/cull/DetailChoice.h"
#include "render_client/cull/Enclosures.h"
#include "render_client/cull/ViewPyramid.h"
#include "render_client/draw/DrawCommands.h"
#include "render_client/draw/LampSets.h"
#include "render_client/draw/NearestFirst.h"
#include "render_client/draw/SceneBuffers.h"
#include "render_client/draw/ShaderSources.h"
#include "render_client/draw/StreamBuffer.h"
#include "render_client/draw/WorldBox.h"

namespace coherency {

/// Draws what moves: light is computed at its vertices, of the lamps chosen for the whole that each belongs
/// to, and its shadows on itself are looked for in every pixel.
class MovingPass {
 public:
  /// `lamp_count` of the chosen lamps, at most kChosenLamps. That and the map's size are fixed, so that the
  /// shader has no loops or branches (on a software renderer they cost ten times the arithmetic).
  MovingPass(const CompiledScene& scene, std::size_t lamp_count, const ShadowMapSize& shadows);

  /// Chooses what is drawn in this frame, by all its views: what one of them may see, and how coarse it may
  /// be. `lamps` as updated for this frame.
  /// `origin`: of the coordinates in which it is drawn, in the world, near the eyes.
  void begin(const CompiledScene& scene, const LampSets& lamps, const Coord3& origin,
             const ViewPyramids& views, const Enclosures& enclosures, const DetailChoice& detail);
  /// Draws a view of the frame, whose uniforms are bound, into the bound framebuffer; with another program
  /// `instead` of its own, if given.
  void draw(const SceneBuffers& buffers, const Program* instead = nullptr) const;

  /// Which of the drawables the frame's draw command of that number draws.
  std::size_t drawn(std::size_t number) const { return seen_[number].drawable; }
  std::size_t count() const { return commands_.size(); }  ///< drawables, in this frame
  std::size_t triangleCount() const { return commands_.triangleCount(); }

 private:
  /// As the shader has it (std430).
  struct Object {
    glm::mat4 world_from_mesh;
    glm::vec4 normal_x_emission;
    glm::vec4 normal_y;
    glm::vec4 normal_z;
    glm::vec4 colour_gloss;
    glm::vec4 place_root;  ///< MovingRoot's place, and its number (exact up to 2^24)
  };
  struct Lamp {
    glm::vec4 position_reach;  ///< from the place: what rests is written once, wherever eyes go
    glm::vec4 colour;
  };
  struct LampSet {
    glm::vec4 others;
    std::array<Lamp, kChosenLamps> lamps;
  };

  struct Seen {
    std::uint32_t drawable;
    IndexRange range;  ///< of the level that is drawn
    bool mirrored;
  };

  void writeLamps(const CompiledScene& scene, const LampSets& lamps);
  static Object objectOf(const Drawable& drawable, const Coord3& origin, const CompiledScene& scene);

  Program program_;
  DrawCommands commands_;
  std::vector<Seen> seen_;  ///< in the scene's order
  NearestFirst order_;      ///< of them
  StreamBuffer objects_;    ///< of them; written while what is read for it is at hand
  Buffer lamp_buffer_;
};

}  // namespace coherency
