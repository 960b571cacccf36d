#include "render_client/draw/SceneBuffers.h"

#include <cstddef>
#include <numeric>

namespace coherency {
namespace {

/// A buffer of size 0 is an error in OpenGL, an empty scene is not.
template <class T>
void store(const Buffer& buffer, const std::vector<T>& data) {
  const auto bytes = static_cast<GLsizeiptr>(data.size() * sizeof(T));
  glNamedBufferStorage(buffer.name(), bytes > 0 ? bytes : 1, bytes > 0 ? data.data() : nullptr, 0);
}

}  // namespace

SceneBuffers::SceneBuffers(const CompiledScene& scene) {
  store(vertices_, scene.vertices());
  store(indices_, scene.indices());
  std::vector<std::uint32_t> numbers(scene.drawables().size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  store(numbers_, numbers);

  const GLuint array = vertex_array_.name();
  glVertexArrayElementBuffer(array, indices_.name());
  glVertexArrayVertexBuffer(array, 0, vertices_.name(), 0, sizeof(MeshVertex));
  glVertexArrayVertexBuffer(array, 1, numbers_.name(), 0, sizeof(std::uint32_t));
  glVertexArrayBindingDivisor(array, 1, 1);
  glVertexArrayAttribFormat(array, 0, 3, GL_FLOAT, GL_FALSE, offsetof(MeshVertex, position));
  glVertexArrayAttribFormat(array, 1, 3, GL_FLOAT, GL_FALSE, offsetof(MeshVertex, normal));
  glVertexArrayAttribIFormat(array, 2, 1, GL_UNSIGNED_INT, 0);
  for (const GLuint attribute : {0U, 1U, 2U}) {
    glVertexArrayAttribBinding(array, attribute, attribute == 2U ? 1U : 0U);
    glEnableVertexArrayAttrib(array, attribute);
  }
}

}  // namespace coherency
