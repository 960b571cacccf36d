#include "render_client/draw/RenderTarget.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace coherency {
namespace {

std::string sizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

void checkSize(int width, int height) {
  GLint limit = 0;
  GLint texture_limit = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture_limit);
  limit = std::min(limit, texture_limit);
  if (width < 1 || height < 1 || width > limit || height > limit)
    throw std::runtime_error("a picture of " + sizeText(width, height) +
                             " pixels cannot be made; width and height " + "must be 1 to " +
                             std::to_string(limit) + " with this driver");
}

/// The count nearest to `wanted` that colour and depth both have; 0 for none.
int nearestSamples(int wanted) {
  if (wanted <= 1) return 0;
  int best = 0;
  for (const GLenum format : {GL_SRGB8_ALPHA8, GL_DEPTH_COMPONENT32F}) {
    GLint count = 0;
    glGetInternalformativ(GL_RENDERBUFFER, format, GL_NUM_SAMPLE_COUNTS, 1, &count);
    std::array<GLint, 16> counts{};
    if (count > static_cast<GLint>(counts.size())) count = static_cast<GLint>(counts.size());
    glGetInternalformativ(GL_RENDERBUFFER, format, GL_SAMPLES, count, counts.data());
    int nearest = 0;
    for (int i = 0; i < count; ++i)
      if (std::abs(counts[static_cast<std::size_t>(i)] - wanted) < std::abs(nearest - wanted))
        nearest = counts[static_cast<std::size_t>(i)];
    best = best == 0 || nearest < best ? nearest : best;
  }
  return best;
}

void checkComplete(const Framebuffer& frame, int width, int height) {
  const GLenum status = glCheckNamedFramebufferStatus(frame.name(), GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("the driver cannot draw to a picture of " + sizeText(width, height) +
                             " pixels (framebuffer status " + std::to_string(status) + ")");
}

}  // namespace

Image readPixels(GLuint framebuffer, int width, int height) {
  const auto row = static_cast<std::size_t>(width) * 3;
  std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(height));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, upside_down.data());
  Image image{width, height, {}};
  image.rgb.reserve(upside_down.size());
  for (auto from = upside_down.end(); from != upside_down.begin();) {
    from -= static_cast<std::ptrdiff_t>(row);
    image.rgb.insert(image.rgb.end(), from, from + static_cast<std::ptrdiff_t>(row));
  }
  return image;
}

void copyToWindow(GLuint framebuffer, int width, int height, int window_width, int window_height) {
  // The bytes are encoded already; a window's framebuffer need not know what sRGB is.
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_FRAMEBUFFER_SRGB);
  const bool same = width == window_width && height == window_height;
  glBlitNamedFramebuffer(framebuffer, 0, 0, 0, width, height, 0, 0, window_width, window_height,
                         GL_COLOR_BUFFER_BIT, same ? GL_NEAREST : GL_LINEAR);
}

RenderTarget::RenderTarget(int width, int height, int samples) : width_(width), height_(height) {
  checkSize(width, height);
  samples_ = nearestSamples(samples);
  glNamedRenderbufferStorageMultisample(drawing_.name(), samples_, GL_SRGB8_ALPHA8, width, height);
  glNamedRenderbufferStorageMultisample(depth_.name(), samples_, GL_DEPTH_COMPONENT32F, width, height);
  glNamedFramebufferRenderbuffer(drawing_frame_.name(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                 drawing_.name());
  glNamedFramebufferRenderbuffer(drawing_frame_.name(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  checkComplete(drawing_frame_, width, height);

  glTextureStorage2D(resolved_.name(), 1, GL_SRGB8_ALPHA8, width, height);
  glTextureParameteri(resolved_.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(resolved_.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(resolved_.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(resolved_.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glNamedFramebufferTexture(resolved_frame_.name(), GL_COLOR_ATTACHMENT0, resolved_.name(), 0);
  checkComplete(resolved_frame_, width, height);
}

void RenderTarget::resolve() const {
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_FRAMEBUFFER_SRGB);
  glBlitNamedFramebuffer(drawing_frame_.name(), resolved_frame_.name(), 0, 0, width_, height_, 0, 0, width_,
                         height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace coherency
