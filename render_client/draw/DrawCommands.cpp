#include "render_client/draw/DrawCommands.h"

#include <algorithm>
#include <cassert>

namespace coherency {

DrawCommands::DrawCommands(std::size_t capacity)
    : capacity_(std::max<std::size_t>(capacity, 1)), buffer_(capacity_ * sizeof(Command)) {}

void DrawCommands::begin() {
  commands_ = buffer_.next<Command>();
  upright_ = mirrored_ = triangles_ = 0;
}

void DrawCommands::add(const IndexRange& range, std::size_t number, bool mirrored) {
  assert(upright_ + mirrored_ < capacity_);
  const std::size_t at = mirrored ? capacity_ - ++mirrored_ : upright_++;
  commands_[at] = {range.index_count, 1, range.first_index, static_cast<GLint>(range.first_vertex),
                   static_cast<GLuint>(number)};
  triangles_ += range.index_count / 3;
}

void DrawCommands::draw() const {
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer_.name());
  const auto issue = [this](std::size_t first, std::size_t count) {
    if (count == 0) return;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes an offset in a pointer's clothes
    const void* offset = reinterpret_cast<const void*>(buffer_.offset() + first * sizeof(Command));
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, offset, static_cast<GLsizei>(count), 0);
  };
  issue(0, upright_);
  if (mirrored_ == 0) return;
  glFrontFace(GL_CW);
  issue(capacity_ - mirrored_, mirrored_);
  glFrontFace(GL_CCW);
}

}  // namespace coherency
