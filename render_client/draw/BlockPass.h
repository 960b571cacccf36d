#pragma once

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

#include "render_client/cull/DetailChoice.h"
#include "render_client/cull/Enclosures.h"
#include "render_client/cull/SphereTree.h"
#include "render_client/draw/DrawCommands.h"
#include "render_client/draw/NearestFirst.h"
#include "render_client/draw/OverheadShadow.h"
#include "render_client/draw/ShaderSources.h"
#include "render_client/draw/StreamBuffer.h"

namespace coherency {

/// Draws blocks of one kind (FixedBlocks). Only what something that moves may cast a shadow on is drawn with
/// a shader that looks for it in every pixel.
class BlockPass {
 public:
  /// `blocks` must outlive this.
  BlockPass(const std::vector<Block>& blocks, LightSource light, const ShadowMapSize& shadows);

  /// Chooses what is drawn in this frame, by all its views: what one of them may see, and how coarse it may
  /// be. `origin`: of the coordinates in which it is drawn, in the world, near the eyes. `shadow` may be
  /// null.
  void begin(const Coord3& origin, const ViewPyramids& views, const Enclosures& enclosures,
             const DetailChoice& detail, const OverheadShadow* shadow);
  /// Draws a view of the frame, whose uniforms and blocks' buffers are bound, into the bound framebuffer;
  /// with another program `instead` of its own, if given.
  void draw(const Program* instead = nullptr) const;

  /// What the frame's draw command of that number draws.
  IndexRange drawn(std::size_t number) const { return rangeOf(blocks_[order_.shown()[number].number]); }
  std::size_t shadedCount() const { return shaded_.size(); }  ///< blocks, in this frame
  std::size_t plainCount() const { return plain_.size(); }
  std::size_t triangleCount() const { return plain_.triangleCount() + shaded_.triangleCount(); }

 private:
  IndexRange rangeOf(const Block& block) const;

  const std::vector<Block>& blocks_;
  DetailChoice detail_;  ///< this frame's
  Program plain_program_;
  std::optional<Program> shaded_program_;
  DrawCommands plain_;
  DrawCommands shaded_;
  SphereTree spheres_;
  std::vector<std::uint32_t> seen_;
  NearestFirst order_;
  std::vector<WorldBox> boxes_;
  StreamBuffer offsets_;  ///< of the blocks' origins, in the order in which they are drawn
};

}  // namespace coherency
