#pragma once

#include "render_client/draw/GlObjects.h"

namespace coherency {

/// A buffer with a block of data for each view of a frame, so that one view's may be written while another's
/// is drawn.
class SlottedBuffer {
 public:
  /// `target`: GL_UNIFORM_BUFFER or GL_SHADER_STORAGE_BUFFER.
  SlottedBuffer(GLenum target, std::size_t block_bytes);

  /// Makes room for as many views; what was written is lost where there was not enough.
  void reserve(std::size_t slots);
  void write(std::size_t slot, const void* data, std::size_t bytes);
  void bind(std::size_t slot, GLuint binding) const;

 private:
  GLenum target_;
  std::size_t stride_;
  std::size_t slots_ = 0;
  Buffer buffer_;
};

}  // namespace coherency
