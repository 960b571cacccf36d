#pragma once

#include <memory>
#include <span>
#include <string>

#include "common/world/Scene.h"
#include "render_client/compile/Illumination.h"
#include "render_client/draw/EyeView.h"
#include "render_client/draw/EyeViews.h"
#include "render_client/draw/IdImage.h"
#include "render_client/draw/Image.h"
#include "render_client/draw/RendererSettings.h"

namespace coherency {

/// What a frame had in it.
struct FrameCounts {
  std::size_t moving = 0;        ///< drawables that move
  std::size_t fixed_shaded = 0;  ///< blocks of what does not, near enough to what does for its shadows
  std::size_t fixed_plain = 0;   ///< the others: a pixel of theirs costs next to nothing
};

/// Draws a tree of objects with OpenGL 4.5 core. Poses are composed in double relative to the eye and cast to
/// float last, depth is reversed with the far plane at infinity (design, "Numerics" 1 and 5). A context must
/// be current, and stay the same, at every call. Shapes, and the light of what never moves (CompiledScene),
/// are computed and uploaded once at construction; afterwards the tree keeps its structure, and only
/// materials, and the transforms of what has the attribute Moving, may change. Where nothing is drawn one
/// sees the sky light.
class Renderer {
 public:
  /// Throws std::runtime_error when the context is older than 4.5 (naming what it is), a shader does not
  /// compile, or the target cannot be made, and what buildMesh() throws. `root` must outlive this. Lamps are
  /// those of the illumination, wherever the tree has some.
  Renderer(const VRObject& root, const Illumination& illumination, int width, int height,
           const RendererSettings& settings = {});
  /// A scene with its own lamps.
  Renderer(const Scene& scene, int width, int height, const RendererSettings& settings = {})
      : Renderer(scene, {scene.lights(), scene.ambient()}, width, height, settings) {}
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws the scene as it now stands into the off-screen target, one view after another. All of them are of
  /// one vehicle.
  void draw(std::span<const EyeView> views);
  /// The part of draw() that is the processor's alone: transforms, clipping, and what to draw; for measuring.
  void prepare(std::span<const EyeView> views);
  /// Draws lines of text over the picture, from the top left corner of each view.
  void drawText(std::span<const EyeView> views, const std::string& text);
  /// Has present() and readPanel() show what the panels before `eyes` must for the lenses of `hmd` to undo
  /// it; costs nothing where it has none. `render_scale` as pictureSize() has it. Throws what DistortionPass
  /// does.
  void setDisplay(const HmdProfile& hmd, EyeChoice eyes, double render_scale = 1.0);
  /// Resolves the target and copies it, or what the panels must show, to the window's framebuffer (0), scaled
  /// to fit `width` x `height`.
  void present(int width, int height);
  /// Waits for the GPU and reads the target back.
  Image readImage();
  /// What present() shows in a window of that size; without a lens the target as it is.
  Image readPanel(int width, int height);

  /// Draws which object shows in each pixel, of what draw() would draw, and reads it back; the picture stays
  /// as it is. Of all pictures of one renderer the numbers are the same. For tests: it is not fast. Throws
  /// std::runtime_error where the driver has no target for it.
  IdImage drawIds(std::span<const EyeView> views);

  void resize(int width, int height);
  int samples() const;                ///< a pixel, as the driver has them
  std::string rendererName() const;   ///< as GL_RENDERER has it
  std::size_t triangleCount() const;  ///< in a view, large faces cut for lighting
  std::size_t vertexCount() const;    ///< of those triangles
  std::size_t vertexBytes() const;    ///< of them, the triangles, and the light of large faces, on the GPU
  std::size_t objectCount() const;    ///< that show faces
  FrameCounts counts() const;         ///< of the last frame

 private:
  struct Gl;
  std::unique_ptr<Gl> gl_;
};

}  // namespace coherency
