#include "render_client/draw/SlottedBuffer.h"

#include <algorithm>

namespace coherency {
namespace {

std::size_t alignedStride(GLenum target, std::size_t bytes) {
  GLint alignment = 1;
  glGetIntegerv(target == GL_UNIFORM_BUFFER ? GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT
                                            : GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT,
                &alignment);
  const auto step = static_cast<std::size_t>(alignment);
  return std::max<std::size_t>((bytes + step - 1) / step, 1) * step;
}

}  // namespace

SlottedBuffer::SlottedBuffer(GLenum target, std::size_t block_bytes)
    : target_(target), stride_(alignedStride(target, block_bytes)) {}

void SlottedBuffer::reserve(std::size_t slots) {
  if (slots <= slots_) return;
  slots_ = slots;
  glNamedBufferData(buffer_.name(), static_cast<GLsizeiptr>(slots_ * stride_), nullptr, GL_STREAM_DRAW);
}

void SlottedBuffer::write(std::size_t slot, const void* data, std::size_t bytes) {
  if (bytes == 0) return;
  glNamedBufferSubData(buffer_.name(), static_cast<GLintptr>(slot * stride_), static_cast<GLsizeiptr>(bytes),
                       data);
}

void SlottedBuffer::bind(std::size_t slot, GLuint binding) const {
  glBindBufferRange(target_, binding, buffer_.name(), static_cast<GLintptr>(slot * stride_),
                    static_cast<GLsizeiptr>(stride_));
}

}  // namespace coherency
