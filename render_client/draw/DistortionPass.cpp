#include "render_client/draw/DistortionPass.h"

#include <cassert>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "render_client/draw/DistortionMesh.h"
#include "render_client/draw/PictureSize.h"
#include "render_client/draw/ShaderProgram.h"

namespace coherency {
namespace {

const char* const kVertexShader = R"(#version 450 core
layout(location = 0) in vec2 panel;
layout(location = 1) in vec2 red_in;
layout(location = 2) in vec2 green_in;
layout(location = 3) in vec2 blue_in;
layout(location = 0) out vec2 red;
layout(location = 1) out vec2 green;
layout(location = 2) out vec2 blue;
void main() {
  gl_Position = vec4(2.0 * panel - 1.0, 0.0, 1.0);
  red = red_in;
  green = green_in;
  blue = blue_in;
}
)";

// An eye's picture ends where the other's begins: nothing is taken from beyond the middle of its last pixels.
const char* const kFragmentShader = R"(#version 450 core
layout(location = 0) in vec2 red;
layout(location = 1) in vec2 green;
layout(location = 2) in vec2 blue;
layout(location = 0) out vec4 colour;
layout(binding = 0) uniform sampler2D picture;
layout(location = 0) uniform vec4 part;  // the eye's of the texture: where it begins, and how large it is
layout(location = 1) uniform vec2 half_pixel;
vec3 at(vec2 place) {
  return texture(picture, clamp(part.xy + place * part.zw, part.xy + half_pixel, part.xy + part.zw - half_pixel)).rgb;
}
void main() { colour = vec4(at(red).r, at(green).g, at(blue).b, 1.0); }
)";

std::vector<const EyeDisplay*> displays(const HmdProfile& hmd, EyeChoice eyes) {
  std::vector<const EyeDisplay*> chosen;
  if (eyes != EyeChoice::Right) chosen.push_back(&hmd.left);
  if (eyes != EyeChoice::Left) chosen.push_back(&hmd.right);
  return chosen;
}

void setAttribute(const VertexArray& array, GLuint index, std::size_t offset) {
  glVertexArrayAttribFormat(array.name(), index, 2, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
  glVertexArrayAttribBinding(array.name(), index, 0);
  glEnableVertexArrayAttrib(array.name(), index);
}

template <class Element>
void fill(const Buffer& buffer, const std::vector<Element>& elements) {
  glNamedBufferStorage(buffer.name(), static_cast<GLsizeiptr>(elements.size() * sizeof(Element)),
                       elements.data(), 0);
}

}  // namespace

DistortionPass::DistortionPass(const HmdProfile& hmd, EyeChoice eyes, double render_scale)
    : panel_(*hmd.panel), program_(makeProgram("distortion", kVertexShader, kFragmentShader)) {
  assert(hasLens(hmd, eyes));
  const PanelSize picture = pictureSize(hmd, eyes, panel_.width, panel_.height, render_scale);
  std::vector<DistortionVertex> vertices;
  std::vector<std::uint32_t> indices;
  for (const EyeDisplay* display : displays(hmd, eyes)) {
    const DistortionMesh mesh = distortionMesh(*display, panel_, picture);
    eyes_.push_back(
        {static_cast<GLsizei>(mesh.indices.size()), indices.size(), static_cast<GLint>(vertices.size())});
    vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
  }
  fill(vertices_, vertices);
  fill(indices_, indices);
  glVertexArrayVertexBuffer(vertex_array_.name(), 0, vertices_.name(), 0, sizeof(DistortionVertex));
  glVertexArrayElementBuffer(vertex_array_.name(), indices_.name());
  setAttribute(vertex_array_, 0, offsetof(DistortionVertex, panel));
  for (GLuint colour = 0; colour < 3; ++colour)
    setAttribute(vertex_array_, 1 + colour,
                 offsetof(DistortionVertex, picture) + colour * sizeof(DistortionVertex::Point));
}

void DistortionPass::resize(int width, int height) {
  if (frame_ && width == width_ && height == height_) return;
  frame_.emplace();
  colour_.emplace();
  glNamedRenderbufferStorage(colour_->name(), GL_SRGB8_ALPHA8, width, height);
  glNamedFramebufferRenderbuffer(frame_->name(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_->name());
  if (glCheckNamedFramebufferStatus(frame_->name(), GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("the driver cannot draw a panel's image of " + std::to_string(width) + "x" +
                             std::to_string(height) + " pixels; give a smaller --size");
  width_ = width;
  height_ = height;
}

void DistortionPass::draw(GLuint picture, int picture_width, int picture_height, int width, int height) {
  resize(width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_->name());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_FRAMEBUFFER_SRGB);
  glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);  // a panel's border
  glUseProgram(program_.name());
  glBindVertexArray(vertex_array_.name());
  glBindTextureUnit(0, picture);
  glUniform2f(1, 0.5F / static_cast<float>(picture_width), 0.5F / static_cast<float>(picture_height));
  const int count = static_cast<int>(eyes_.size());
  const PanelPlace place = placePanel(panel_, width / count, height);
  for (int i = 0; i < count; ++i) {
    const Eye& eye = eyes_[static_cast<std::size_t>(i)];
    const float share = 1.0F / static_cast<float>(count);
    glScissor(i * (width / count) + place.x, place.y, place.width, place.height);
    glViewport(i * (width / count) + place.x, place.y, place.width, place.height);
    glUniform4f(0, static_cast<float>(i) * share, 0.0F, share, 1.0F);
    // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes an offset in a pointer's clothes
    const void* offset = reinterpret_cast<const void*>(eye.first_index * sizeof(std::uint32_t));
    glDrawElementsBaseVertex(GL_TRIANGLES, eye.indices, GL_UNSIGNED_INT, offset, eye.first_vertex);
  }
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace coherency
