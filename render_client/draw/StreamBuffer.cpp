#include "render_client/draw/StreamBuffer.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace coherency {

std::size_t alignedForBinding(std::size_t bytes) {
  GLint uniform = 1;
  GLint storage = 1;
  glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &uniform);
  glGetIntegerv(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT, &storage);
  const auto step = static_cast<std::size_t>(std::max({uniform, storage, 16}));  // all are powers of two
  return std::max<std::size_t>((bytes + step - 1) / step, 1) * step;
}

StreamBuffer::StreamBuffer(std::size_t bytes)
    : bytes_(std::max<std::size_t>(bytes, 1)), stride_(alignedForBinding(bytes_)) {
  constexpr GLbitfield kFlags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  const auto all = static_cast<GLsizeiptr>(kParts * stride_);
  glNamedBufferStorage(buffer_.name(), all, nullptr, kFlags);
  memory_ = static_cast<std::byte*>(glMapNamedBufferRange(buffer_.name(), 0, all, kFlags));
  if (memory_ == nullptr)
    throw std::runtime_error("the driver has no " + std::to_string(kParts * stride_) +
                             " bytes of memory for what changes with every frame");
}

StreamBuffer::~StreamBuffer() {
  for (const GLsync sync : read_)
    if (sync != nullptr) glDeleteSync(sync);
}

std::byte* StreamBuffer::nextPart() {
  if (std::exchange(written_, true)) {
    read_[turn_] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    turn_ = (turn_ + 1) % kParts;
  }
  if (const GLsync sync = std::exchange(read_[turn_], nullptr); sync != nullptr) {
    glClientWaitSync(sync, GL_SYNC_FLUSH_COMMANDS_BIT, GL_TIMEOUT_IGNORED);
    glDeleteSync(sync);
  }
  return memory_ + offset();
}

void StreamBuffer::bind(GLenum target, GLuint binding, std::size_t offset, std::size_t bytes) const {
  glBindBufferRange(target, binding, buffer_.name(), static_cast<GLintptr>(this->offset() + offset),
                    static_cast<GLsizeiptr>(bytes));
}

}  // namespace coherency
