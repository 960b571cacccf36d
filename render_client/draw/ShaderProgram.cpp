#include "render_client/draw/ShaderProgram.h"

#include <array>
#include <stdexcept>

namespace coherency {
namespace {

class Stage {
 public:
  Stage(const std::string& name, GLenum kind, const char* source) : shader_(glCreateShader(kind)) {
    glShaderSource(shader_, 1, &source, nullptr);
    glCompileShader(shader_);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader_, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return;
    std::array<char, 2048> log{};
    glGetShaderInfoLog(shader_, static_cast<GLsizei>(log.size()), nullptr, log.data());
    glDeleteShader(shader_);
    throw std::runtime_error("shader '" + name + "' (" + (kind == GL_VERTEX_SHADER ? "vertex" : "fragment") +
                             ") does not compile: " + log.data());
  }
  ~Stage() { glDeleteShader(shader_); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  GLuint name() const { return shader_; }

 private:
  GLuint shader_;
};

}  // namespace

Program makeProgram(const std::string& name, const std::string& vertex_source,
                    const std::string& fragment_source) {
  const Stage vertex(name, GL_VERTEX_SHADER, vertex_source.c_str());
  const Stage fragment(name, GL_FRAGMENT_SHADER, fragment_source.c_str());
  Program program;
  glAttachShader(program.name(), vertex.name());
  glAttachShader(program.name(), fragment.name());
  glLinkProgram(program.name());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return program;
  std::array<char, 2048> log{};
  glGetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw std::runtime_error("shader program '" + name + "' does not link: " + log.data());
}

}  // namespace coherency
