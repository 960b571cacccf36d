#include "render_client/draw/SceneBuffers.h"

#include <algorithm>
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

template <class Vertex>
void SceneBuffers::upload(Surfaces& to, const coherency::Surfaces<Vertex>& from) {
  store(to.vertices, from.vertices);
  store(to.indices, from.indices);
  const GLuint array = to.array.name();
  glVertexArrayElementBuffer(array, to.indices.name());
  glVertexArrayVertexBuffer(array, 0, to.vertices.name(), 0, sizeof(Vertex));
  glVertexArrayVertexBuffer(array, 1, numbers_.name(), 0, sizeof(std::uint32_t));
  glVertexArrayBindingDivisor(array, 1, 1);
  glVertexArrayAttribFormat(array, 0, 3, GL_FLOAT, GL_FALSE, offsetof(Vertex, position));
  glVertexArrayAttribIFormat(array, 2, 1, GL_UNSIGNED_INT, 0);
  for (const GLuint attribute : {0U, 1U, 2U}) {
    glVertexArrayAttribBinding(array, attribute, attribute == 2U ? 1U : 0U);
    glEnableVertexArrayAttrib(array, attribute);
  }
}

SceneBuffers::SceneBuffers(const CompiledScene& scene) {
  std::vector<std::uint32_t> numbers(
      std::max(scene.fixed().drawables.size(), scene.moving().drawables.size()));
  std::iota(numbers.begin(), numbers.end(), 0U);
  store(numbers_, numbers);
  upload(fixed_, scene.fixed());
  upload(moving_, scene.moving());
  glVertexArrayAttribFormat(fixed_.array.name(), 1, 4, GL_UNSIGNED_SHORT, GL_TRUE,
                            offsetof(LitVertex, light));
  glVertexArrayAttribFormat(moving_.array.name(), 1, 3, GL_FLOAT, GL_FALSE, offsetof(MeshVertex, normal));
}

}  // namespace coherency
