#pragma once

#include <optional>

#include "render_client/draw/GlObjects.h"
#include "render_client/draw/Image.h"

namespace coherency {

/// Waits for the GPU and reads a framebuffer's colour.
Image readPixels(GLuint framebuffer, int width, int height);
/// Copies a framebuffer of encoded bytes to the window's (0), scaled where the sizes differ.
void copyToWindow(GLuint framebuffer, int width, int height, int window_width, int window_height);

/// Off-screen picture: sRGB colour and 32-bit float depth, several samples a pixel, and the same resolved to
/// one.
class RenderTarget {
 public:
  /// Throws std::runtime_error naming the sizes there are when it cannot be made.
  RenderTarget(int width, int height, int samples);

  void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, drawing_frame_.name()); }
  /// Averages the samples, in linear light.
  void resolve() const;
  /// Copies what resolve() left to framebuffer 0.
  void copyToWindow(int width, int height) const {
    coherency::copyToWindow(resolved_frame_.name(), width_, height_, width, height);
  }
  Image read() const { return readPixels(resolved_frame_.name(), width_, height_); }
  /// What resolve() left, to be sampled: sRGB, bilinear, as it is up to its border.
  GLuint texture() const { return resolved_.name(); }

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_ == 0 ? 1 : samples_; }

 private:
  int width_;
  int height_;
  int samples_;  ///< 0: not multisampled
  Framebuffer drawing_frame_;
  Renderbuffer drawing_;
  Renderbuffer depth_;
  Framebuffer resolved_frame_;
  Texture resolved_;
};

}  // namespace coherency
