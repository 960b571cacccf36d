#include "render_client/draw/TextOverlay.h"

#include <algorithm>
#include <cstring>

#include <glm/mat3x3.hpp>
#include <stb/stb_easy_font.h>

#include "render_client/draw/ShaderProgram.h"
#include "render_client/draw/ShaderSources.h"

namespace coherency {
namespace {

constexpr std::size_t kMaxQuads = 16384;
constexpr float kLarge = 2.0F;     // pixels a dot
constexpr float kNarrow = 520.0F;  // pixels; where there are fewer, a dot is one
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

float width(char* line) {
  return static_cast<float>(stb_easy_font_width(line));
}

/// stb_easy_font looks letters up in a table without asking whether they are in it.
char shown(char c) {
  return c == '\n' || (c >= ' ' && c <= '~') ? c : '?';
}

float textWidth(const EyeView& view) {
  return static_cast<float>(view.text_width > 0.0 ? view.text_width : view.width - view.text_x);
}

/// From dots to the view's clip coordinates (x, y and w), by the directions in which the head has them.
glm::mat3 clipFromText(const EyeView& view, double scale) {
  const FieldOfView& v = view.view;
  const double width = v.tan_left + v.tan_right;
  const double height = v.tan_down + v.tan_up;
  const double across = width / view.width;  // tangents of a pixel
  const double upright = height / view.height;
  const glm::dmat3 direction_from_dots(
      glm::dvec3(scale * across, 0.0, 0.0), glm::dvec3(0.0, -scale * upright, 0.0),
      glm::dvec3(view.text_x * across - v.tan_left, v.tan_up - view.text_y * upright, -1.0));
  const glm::dmat3 clip_from_direction(
      glm::dvec3(2.0 / width, 0.0, 0.0), glm::dvec3(0.0, 2.0 / height, 0.0),
      glm::dvec3((v.tan_right - v.tan_left) / width, (v.tan_up - v.tan_down) / height, -1.0));
  return glm::mat3(clip_from_direction * glm::dmat3(view.t_eye_head.glm()) * direction_from_dots);
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
  letters_.reserve(kMaxQuads + 2);  // a letter, and perhaps a line break, beyond which none is added
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

/// Lines that are too wide are broken at spaces, else where they are full.
void TextOverlay::breakLines(const std::string& text, float widest) {
  letters_.clear();
  std::size_t line = 0;  // where it begins
  for (std::size_t i = 0; i < text.size() && letters_.size() < kMaxQuads; ++i) {
    letters_ += shown(text[i]);
    if (text[i] == '\n') line = letters_.size();
    if (letters_.size() < line + 2 || width(letters_.data() + line) <= widest) continue;
    const std::size_t last = letters_.size() - 1;
    const std::size_t space = letters_.find_last_of(' ', last - 1);
    line = space == std::string::npos || space <= line ? last : space + 1;
    letters_.insert(line++, 1, '\n');
  }
}

/// Fills the corner buffer, the ground first and then the letters; returns the number of quads.
std::size_t TextOverlay::layOut(const std::string& text, float widest) {
  breakLines(text, widest - 2.0F * kMargin);
  const float right = 2.0F * kMargin + width(letters_.data());
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
  if (text.empty() || views.empty()) return;
  float narrowest = textWidth(views.front());
  for (const EyeView& view : views) narrowest = std::min(narrowest, textWidth(view));
  const float scale = narrowest < kNarrow ? 1.0F : kLarge;
  const std::size_t quads = layOut(text, narrowest / scale);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_FRAMEBUFFER_SRGB);  // blended in linear light
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram(program_.name());
  glBindVertexArray(vertex_array_.name());
  for (const EyeView& view : views) {
    glViewport(view.x, view.y, view.width, view.height);
    const glm::mat3 clip_from_text = clipFromText(view, static_cast<double>(scale));
    glUniformMatrix3fv(0, 1, GL_FALSE, &clip_from_text[0][0]);
    glUniform4f(1, 0.0F, 0.0F, 0.0F, 0.7F);
    drawQuads(0, 1);
    glUniform4f(1, 0.9F, 0.9F, 0.9F, 1.0F);
    drawQuads(1, quads - 1);
  }
  glDisable(GL_BLEND);
}

}  // namespace coherency
