#pragma once

#include <optional>
#include <span>
#include <string>

#include "render_client/compile/CompiledScene.h"
#include "render_client/draw/BlockPass.h"
#include "render_client/draw/EyeView.h"
#include "render_client/draw/FrameCounts.h"
#include "render_client/draw/IdPicture.h"
#include "render_client/draw/LampSets.h"
#include "render_client/draw/MovingPass.h"
#include "render_client/draw/OverheadShadow.h"
#include "render_client/draw/RendererSettings.h"
#include "render_client/draw/SceneBuffers.h"
#include "render_client/draw/ViewUniforms.h"

namespace coherency {

/// Everything that is made of a tree as it stood at one moment, and goes together when the tree is no longer
/// as it was compiled (CompiledScene::isStale()). What the scene has nothing for is not there: no shadow map
/// and no shaders that look in one where nothing moves, no shader for lamps, textures or blocks that are not.
class DrawnScene {
 public:
  /// Throws what CompiledScene and its parts throw.
  DrawnScene(const VRObject& root, const Illumination& illumination, const RendererSettings& settings,
             const ObjectSet& found_to_move = {});

  const CompiledScene& compiled() const { return compiled_; }
  /// All that is done for a frame before the GPU is told to draw it: reads the tree anew, and chooses what
  /// these views may see. Not while it is stale.
  void prepare(std::span<const EyeView> views);
  /// Draws the shadow map, where there is one, as last prepared; leaves another framebuffer bound.
  void drawShadows();
  /// Into the bound framebuffer. `views` as prepared; with `instead`, what shows in place of how it looks.
  void draw(std::span<const EyeView> views, const IdPicture* instead = nullptr) const;
  /// Into a target of its own, of that size. `views` as prepared.
  IdImage drawIds(std::span<const EyeView> views, int width, int height);

  FrameCounts counts() const;  ///< of the last frame
  /// What of the settings and of the shaders was left out, in words.
  std::string explain() const;

 private:
  ShadowMapSize shadowMap() const;
  void clipTo(std::span<const EyeView> views);
  DetailChoice detailFor(const EyeView& view) const;
  void drawView(const IdPicture* instead) const;

  RendererSettings settings_;
  Ambient ambient_;
  CompiledScene compiled_;
  SceneBuffers buffers_;
  LampSets lamps_;
  ViewPyramids pyramids_;
  Enclosures enclosures_;
  ViewUniforms uniforms_;
  std::optional<MovingPass> moving_;
  std::optional<BlockPass> lit_;
  std::optional<BlockPass> mapped_;
  std::optional<OverheadShadow> shadow_;
  std::optional<IdPicture> ids_;  ///< once it has been asked for
};

}  // namespace coherency
