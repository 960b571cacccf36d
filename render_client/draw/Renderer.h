#pragma once

#include <memory>
#include <span>
#include <string>

#include "common/world/Scene.h"
#include "render_client/compile/CompileReport.h"
#include "render_client/compile/Illumination.h"
#include "render_client/draw/EyeView.h"
#include "render_client/draw/EyeViews.h"
#include "render_client/draw/FrameCounts.h"
#include "render_client/draw/IdImage.h"
#include "render_client/draw/Image.h"
#include "render_client/draw/RendererSettings.h"

namespace coherency {

/// Draws a tree of objects with OpenGL 4.5 core. Poses are composed in double relative to the eye and cast to
/// float last, depth is reversed with the far plane at infinity (design, "Numerics" 1 and 5). A context must
/// be current, and stay the same, at every call. Where nothing is drawn one sees the sky light.
///
/// Shapes, and the light of what never moves (CompiledScene), are computed and uploaded at construction. What
/// is declared Moving moves for nothing; what is declared Fixed cannot be moved while this lives. When
/// anything else moves, or a shape or a member changes or dies, the next draw() compiles the tree again,
/// which takes as long as the first time (half a second for the laboratory): what moved counts as moving from
/// then on. What is repainted shows its new colour, and the light on others keeps the old one until then.
class Renderer {
 public:
  /// Throws std::runtime_error when the context is older than 4.5 (naming what it is), a shader does not
  /// compile, or the target cannot be made, and what buildMesh() throws. Lamps are those of the
  /// illumination, wherever the tree has some. `root` is to outlive the last draw().
  Renderer(const VRObject& root, const Illumination& illumination, int width, int height,
           const RendererSettings& settings = {});
  /// A scene with its own lamps, and no shadows about another vehicle where it has no robot.
  Renderer(const Scene& scene, int width, int height, const RendererSettings& settings = {});
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws the scene as it now stands into the off-screen target, one view after another. All of them are of
  /// one vehicle. Throws std::logic_error when the tree has died, and what the constructor throws where the
  /// tree has to be compiled again and cannot; it may then be mended.
  void draw(std::span<const EyeView> views);
  /// The part of draw() that is the processor's alone: transforms, clipping, and what to draw; for measuring.
  void prepare(std::span<const EyeView> views);
  /// Draws lines of text over the picture, from the top left corner of each view.
  void drawText(std::span<const EyeView> views, const std::string& text);
  /// Has present() and readPanel() show what the panels before `eyes` must for the lenses of `hmd` to undo
  /// it; costs nothing where it has none. `render_scale` as pictureSize() has it. Throws what DistortionPass
  /// does.
  void setDisplay(const HmdProfile& hmd, EyeChoice eyes, double render_scale = 1.0);
  /// Returns when all that was drawn is complete.
  void finish();
  /// Resolves the target and copies it, or what the panels must show, to the window's framebuffer (0), scaled
  /// to fit `width` x `height`.
  void present(int width, int height);
  /// Waits for the GPU and reads the target back.
  Image readImage();
  /// What present() shows in a window of that size; without a lens the target as it is.
  Image readPanel(int width, int height);

  /// Draws which object shows in each pixel, of what draw() would draw, and reads it back; the picture stays
  /// as it is. Of all pictures of one compilation the numbers are the same. For tests: it is not fast. Throws
  /// what draw() throws, and std::runtime_error where the driver has no target for it.
  IdImage drawIds(std::span<const EyeView> views);

  void resize(int width, int height);
  int samples() const;                ///< a pixel, as the driver has them
  std::string rendererName() const;   ///< as GL_RENDERER has it
  std::size_t triangleCount() const;  ///< all of the scene's, as they are drawn in full detail
  std::size_t vertexCount() const;    ///< of those triangles
  FrameCounts counts() const;         ///< of the last frame

  const CompileReport& report() const;  ///< of the last compilation; its `found` are those found to move
  /// The report in words, with what of the renderer was left out as the scene does not need it.
  std::string explain() const;
  std::size_t compilations() const;  ///< 1, and one more each time the tree was compiled again

 private:
  struct Gl;
  std::unique_ptr<Gl> gl_;
};

}  // namespace coherency
