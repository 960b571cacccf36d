#pragma once

#include <array>
#include <cstddef>

#include "render_client/draw/GlObjects.h"

namespace coherency {

/// Memory that the processor writes and the GPU reads, mapped once and for all: three parts that take turns,
/// so that one may be written while the GPU still reads another (Hrabcak & Masserann, "Asynchronous buffer
/// transfers", OpenGL Insights, 2012).
class StreamBuffer {
 public:
  /// `bytes` of a part, at least 1. Throws std::runtime_error where the driver has no such memory.
  explicit StreamBuffer(std::size_t bytes);
  ~StreamBuffer();
  StreamBuffer(const StreamBuffer&) = delete;
  StreamBuffer& operator=(const StreamBuffer&) = delete;

  /// Goes on to the next part, waits until the GPU has done with it, and returns where to write. What was
  /// drawn from the part before must have been issued.
  template <class T>
  T* next() {
    return reinterpret_cast<T*>(nextPart());
  }
  /// Binds some of the part to an indexed target. `offset`: a multiple of what the target asks for.
  void bind(GLenum target, GLuint binding, std::size_t offset, std::size_t bytes) const;
  void bind(GLenum target, GLuint binding) const { bind(target, binding, 0, bytes_); }
  GLuint name() const { return buffer_.name(); }
  std::size_t offset() const { return turn_ * stride_; }  ///< of the part in the buffer, bytes
  std::size_t bytes() const { return bytes_; }

 private:
  static constexpr std::size_t kParts = 3;

  std::byte* nextPart();

  std::size_t bytes_;
  std::size_t stride_;
  std::size_t turn_ = 0;
  bool written_ = false;
  Buffer buffer_;
  std::byte* memory_;
  std::array<GLsync, kParts> read_{};  ///< when the GPU has read a part
};

/// Rounded up to what a driver asks of offsets into a buffer of uniforms or storage.
std::size_t alignedForBinding(std::size_t bytes);

}  // namespace coherency
