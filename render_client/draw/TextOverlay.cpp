#include "render_client/draw/TextOverlay.h"

#include <algorithm>
#include <cstring>

#include <stb/stb_easy_font.h>

#include "render_client/draw/ShaderProgram.h"
#include "render_client/draw/ShaderSources.h"

namespace coherency {
namespace {

constexpr std::size_t kMaxQuads = 16384;
constexpr float kScale = 2.0F;
constexpr float kMargin = 4.0F;

struct Corner {  // as stb_easy_font writes it
  float x, y, z;
  std::uint32_t colour;
};

std::vector<std::uint32_t> quadIndices() {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t q = 0; q < kMaxQuads * 4; q += 4)
    indices.insert(indices.end(), {q, q + 1, q + 2, q, q + 2, q + 3});
  return indices;
}

void drawQuads(std::size_t first, std::size_t count) {
  // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes an offset in a pointer's clothes
  const void* offset = reinterpret_cast<const void*>(first * 6 * sizeof(std::uint32_t));
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count * 6), GL_UNSIGNED_INT, offset);
}

}  // namespace

TextOverlay::TextOverlay()
    : program_(makeProgram("text", kTextVertexShader, kTextFragmentShader)),
      corners_(kMaxQuads * 4 * sizeof(Corner)) {
  const std::vector<std::uint32_t> indices = quadIndices();
  glNamedBufferStorage(indices_.name(), static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                       indices.data(), 0);
  glNamedBufferStorage(corners_buffer_.name(), static_cast<GLsizeiptr>(corners_.size()), nullptr,
                       GL_DYNAMIC_STORAGE_BIT);
  glVertexArrayElementBuffer(vertex_array_.name(), indices_.name());
  glVertexArrayVertexBuffer(vertex_array_.name(), 0, corners_buffer_.name(), 0, sizeof(Corner));
  glVertexArrayAttribFormat(vertex_array_.name(), 0, 2, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(vertex_array_.name(), 0, 0);
  glEnableVertexArrayAttrib(vertex_array_.name(), 0);
}

/// Fills the corner buffer, the ground first and then the letters; returns the number of quads.
std::size_t TextOverlay::layOut(const std::string& text) {
  letters_ = text;
  // stb_easy_font looks letters up in a table without asking whether they are in it.
  std::replace_if(
      letters_.begin(), letters_.end(), [](char c) { return c != '\n' && (c < ' ' || c > '~'); }, '?');
  const float right = 2.0F * kMargin + static_cast<float>(stb_easy_font_width(letters_.data()));
  const float bottom = 2.0F * kMargin + static_cast<float>(stb_easy_font_height(letters_.data()));
  const Corner ground[4] = {{0, 0, 0, 0}, {right, 0, 0, 0}, {right, bottom, 0, 0}, {0, bottom, 0, 0}};
  std::memcpy(corners_.data(), ground, sizeof(ground));
  const int letters =
      stb_easy_font_print(kMargin, kMargin, letters_.data(), nullptr, corners_.data() + sizeof(ground),
                          static_cast<int>(corners_.size() - sizeof(ground)));
  const std::size_t quads = 1 + static_cast<std::size_t>(letters);
  glNamedBufferSubData(corners_buffer_.name(), 0, static_cast<GLsizeiptr>(quads * 4 * sizeof(Corner)),
                       corners_.data());
  return quads;
}

void TextOverlay::draw(std::span<const EyeView> views, const std::string& text) {
  if (text.empty()) return;
  const std::size_t quads = layOut(text);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_FRAMEBUFFER_SRGB);  // blended in linear light
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram(program_.name());
  glBindVertexArray(vertex_array_.name());
  for (const EyeView& view : views) {
    glViewport(view.x, view.y, view.width, view.height);
    glUniform4f(0, 2.0F / static_cast<float>(view.width), 2.0F / static_cast<float>(view.height), kScale,
                0.0F);
    glUniform4f(1, 0.0F, 0.0F, 0.0F, 0.7F);
    drawQuads(0, 1);
    glUniform4f(1, 0.9F, 0.9F, 0.9F, 1.0F);
    drawQuads(1, quads - 1);
  }
  glDisable(GL_BLEND);
}

}  // namespace coherency
