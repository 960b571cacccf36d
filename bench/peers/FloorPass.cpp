#include "bench/peers/FloorPass.h"

#include <algorithm>
#include <numeric>

namespace coherency {

FloorPass::FloorPass(Program made, Program made_for_marking, const VertexLayout& layout,
                     std::size_t instances)
    : program(std::move(made)),
      marking(std::move(made_for_marking)),
      instances_(std::max<std::size_t>(instances, 1)) {
  std::vector<std::uint32_t> numbers(instances_);
  std::iota(numbers.begin(), numbers.end(), 0U);
  fill(numbers_, numbers);
  const GLuint array = array_.name();
  glVertexArrayElementBuffer(array, indices_.name());
  glVertexArrayVertexBuffer(array, 0, vertices.name(), 0, layout.stride);
  glVertexArrayVertexBuffer(array, 1, numbers_.name(), 0, sizeof(std::uint32_t));
  glVertexArrayBindingDivisor(array, 1, 1);
  glVertexArrayAttribFormat(array, 0, 3, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribFormat(array, 1, layout.size, layout.type, layout.normalised, layout.offset);
  glVertexArrayAttribIFormat(array, 2, 1, GL_UNSIGNED_INT, 0);
  for (const GLuint attribute : {0U, 1U, 2U}) {
    glVertexArrayAttribBinding(array, attribute, attribute == 2U ? 1U : 0U);
    glEnableVertexArrayAttrib(array, attribute);
  }
  if (layout.material == 0) return;
  glVertexArrayAttribFormat(array, 3, 4, GL_UNSIGNED_BYTE, GL_TRUE, layout.material);
  glVertexArrayAttribBinding(array, 3, 0);
  glEnableVertexArrayAttrib(array, 3);
}

void FloorPass::fill(const Buffer& buffer, const void* data, std::size_t bytes) {
  // A buffer of size 0 is an error in OpenGL.
  glNamedBufferData(buffer.name(), static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 1)),
                    bytes > 0 ? data : nullptr, GL_STATIC_DRAW);
}

void FloorPass::set(FloorBatch batch) {
  batch_ = std::move(batch);
  fill(indices_, batch_.indices);
  fill(commands_, batch_.commands);
}

void FloorPass::drawWith(const Program& used) const {
  if (batch_.commands.empty()) return;
  glUseProgram(used.name());
  glBindVertexArray(array_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, objects.name());
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands_.name());
  glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr,
                              static_cast<GLsizei>(batch_.commands.size()), 0);
}

void FloorPass::mark() const {
  std::vector<std::uint32_t> first_triangles(instances_);
  for (const DrawCommand& command : batch_.commands)
    first_triangles[command.base_instance] = command.first_index / 3;
  fill(first_triangles_, first_triangles);
  fill(marks_, std::vector<std::uint32_t>(batch_.indices.size() / 3));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, first_triangles_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, marks_.name());
  drawWith(marking);
}

FloorBatch FloorPass::marked() const {
  std::vector<std::uint32_t> marks(batch_.indices.size() / 3);
  if (marks.empty()) return {};
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(marks_.name(), 0, static_cast<GLsizeiptr>(marks.size() * sizeof(std::uint32_t)),
                          marks.data());
  FloorBatch kept;
  for (DrawCommand command : batch_.commands) {
    const std::uint32_t* indices = &batch_.indices[command.first_index];
    const std::uint32_t* mark = &marks[command.first_index / 3];
    command.first_index = static_cast<GLuint>(kept.indices.size());
    for (std::uint32_t i = 0; i < command.count; i += 3)
      if (mark[i / 3] != 0) kept.indices.insert(kept.indices.end(), indices + i, indices + i + 3);
    command.count = static_cast<GLuint>(kept.indices.size()) - command.first_index;
    if (command.count > 0) kept.commands.push_back(command);
  }
  return kept;
}

}  // namespace coherency
