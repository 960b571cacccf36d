#pragma once

#include <optional>
#include <vector>

#include "common/config/HmdProfile.h"
#include "render_client/draw/EyeViews.h"
#include "render_client/draw/GlObjects.h"
#include "render_client/draw/Image.h"

namespace coherency {

/// Makes of the eyes' pictures what the panels must show for the lenses before them to undo it: a mesh an eye
/// (DistortionMesh), made once, drawn over the resolved picture after each frame. Colours are taken in linear
/// light, each from where its own curve has it.
class DistortionPass {
 public:
  /// Precondition: hasLens(hmd, eyes). `render_scale` as pictureSize() has it. Throws what distortionMesh()
  /// does.
  DistortionPass(const HmdProfile& hmd, EyeChoice eyes, double render_scale);

  /// `picture`: an sRGB texture with the eyes' pictures side by side. Leaves framebuffer() with the panels'
  /// image on `width` x `height` pixels, all eyes together. Throws std::runtime_error where the driver cannot
  /// make one so large.
  void draw(GLuint picture, int picture_width, int picture_height, int width, int height);
  GLuint framebuffer() const { return frame_->name(); }

 private:
  void resize(int width, int height);

  struct Eye {
    GLsizei indices = 0;
    std::size_t first_index = 0;
    GLint first_vertex = 0;
  };

  PanelSize panel_;
  std::vector<Eye> eyes_;
  Program program_;
  Buffer vertices_;
  Buffer indices_;
  VertexArray vertex_array_;
  int width_ = 0;
  int height_ = 0;
  std::optional<Framebuffer> frame_;
  std::optional<Renderbuffer> colour_;
};

}  // namespace coherency
