#pragma once

#include <optional>

#include "render_client/draw/GlObjects.h"
#include "render_client/draw/Image.h"

namespace coherency {

/// Off-screen picture: sRGB colour and 32-bit float depth, several samples a pixel, and the same resolved to
/// one.
class RenderTarget {
 public:
  /// Throws std::runtime_error naming the sizes there are when it cannot be made.
  RenderTarget(int width, int height, int samples);

  void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, drawing_.frame.name()); }
  /// Averages the samples, in linear light.
  void resolve() const;
  /// Copies what resolve() left to framebuffer 0.
  void copyToWindow(int width, int height) const;
  Image read() const;

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_ == 0 ? 1 : samples_; }

 private:
  struct Surface {
    Framebuffer frame;
    Renderbuffer colour;
  };

  int width_;
  int height_;
  int samples_;  ///< 0: not multisampled
  Surface drawing_;
  Renderbuffer depth_;
  Surface resolved_;
};

}  // namespace coherency
