#include "render_client/draw/RenderTarget.h"

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
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
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

RenderTarget::RenderTarget(int width, int height, int samples) : width_(width), height_(height) {
  checkSize(width, height);
  samples_ = nearestSamples(samples);
  glNamedRenderbufferStorageMultisample(drawing_.colour.name(), samples_, GL_SRGB8_ALPHA8, width, height);
  glNamedRenderbufferStorageMultisample(depth_.name(), samples_, GL_DEPTH_COMPONENT32F, width, height);
  glNamedFramebufferRenderbuffer(drawing_.frame.name(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                 drawing_.colour.name());
  glNamedFramebufferRenderbuffer(drawing_.frame.name(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  checkComplete(drawing_.frame, width, height);

  glNamedRenderbufferStorage(resolved_.colour.name(), GL_SRGB8_ALPHA8, width, height);
  glNamedFramebufferRenderbuffer(resolved_.frame.name(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                 resolved_.colour.name());
  checkComplete(resolved_.frame, width, height);
}

void RenderTarget::resolve() const {
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_FRAMEBUFFER_SRGB);
  glBlitNamedFramebuffer(drawing_.frame.name(), resolved_.frame.name(), 0, 0, width_, height_, 0, 0, width_,
                         height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void RenderTarget::copyToWindow(int width, int height) const {
  // The bytes are encoded already; a window's framebuffer need not know what sRGB is.
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_FRAMEBUFFER_SRGB);
  const bool same = width == width_ && height == height_;
  glBlitNamedFramebuffer(resolved_.frame.name(), 0, 0, 0, width_, height_, 0, 0, width, height,
                         GL_COLOR_BUFFER_BIT, same ? GL_NEAREST : GL_LINEAR);
}

Image RenderTarget::read() const {
  const auto row = static_cast<std::size_t>(width_) * 3;
  std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(height_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.frame.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, upside_down.data());
  Image image{width_, height_, {}};
  image.rgb.reserve(upside_down.size());
  for (auto from = upside_down.end(); from != upside_down.begin();) {
    from -= static_cast<std::ptrdiff_t>(row);
    image.rgb.insert(image.rgb.end(), from, from + static_cast<std::ptrdiff_t>(row));
  }
  return image;
}

}  // namespace coherency
