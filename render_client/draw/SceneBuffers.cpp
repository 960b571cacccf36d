#include "render_client/draw/SceneBuffers.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace coherency {
namespace {

/// A buffer of size 0 is an error in OpenGL, an empty scene is not.
template <class T>
void store(const Buffer& buffer, const std::vector<T>& data, GLbitfield flags = 0) {
  const auto bytes = static_cast<GLsizeiptr>(data.size() * sizeof(T));
  glNamedBufferStorage(buffer.name(), bytes > 0 ? bytes : 1, bytes > 0 ? data.data() : nullptr, flags);
}

void addMaterial(GLuint array, std::size_t offset) {
  glVertexArrayAttribFormat(array, 3, 4, GL_UNSIGNED_BYTE, GL_TRUE, static_cast<GLuint>(offset));
  glVertexArrayAttribBinding(array, 3, 0);
  glEnableVertexArrayAttrib(array, 3);
}

}  // namespace

template <class Vertex>
void SceneBuffers::upload(Surfaces& to, const std::vector<Vertex>& vertices,
                          const std::vector<std::uint32_t>& indices) {
  store(to.vertices, vertices, GL_DYNAMIC_STORAGE_BIT);
  store(to.indices, indices);
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
  const FixedBlocks& fixed = scene.fixed();
  std::vector<std::uint32_t> numbers(
      std::max({fixed.lit.blocks.size(), fixed.mapped.blocks.size(), scene.moving().drawables.size()}));
  std::iota(numbers.begin(), numbers.end(), 0U);
  store(numbers_, numbers);
  upload(lit_, fixed.lit.vertices, fixed.lit.indices);
  upload(mapped_, fixed.mapped.vertices, fixed.mapped.indices);
  upload(moving_, scene.moving().vertices, scene.moving().indices);
  upload(fixed.lightmap);
  glVertexArrayAttribFormat(lit_.array.name(), 1, 4, GL_UNSIGNED_SHORT, GL_TRUE, offsetof(LitVertex, light));
  glVertexArrayAttribFormat(mapped_.array.name(), 1, 2, GL_FLOAT, GL_FALSE, offsetof(MappedVertex, place));
  glVertexArrayAttribFormat(moving_.array.name(), 1, 3, GL_FLOAT, GL_FALSE, offsetof(MeshVertex, normal));
  addMaterial(lit_.array.name(), offsetof(LitVertex, material));
  addMaterial(mapped_.array.name(), offsetof(MappedVertex, material));
}

template <class Vertex>
void SceneBuffers::rewrite(Surfaces& to, const BlockSurfaces<Vertex>& from, const VRObject& object) {
  for (const std::uint32_t place : from.partsOf(object)) {
    const BlockPart& part = from.parts[place];
    glNamedBufferSubData(to.vertices.name(), static_cast<GLintptr>(part.range.first_vertex * sizeof(Vertex)),
                         static_cast<GLsizeiptr>(part.vertex_count * sizeof(Vertex)),
                         &from.vertices[part.range.first_vertex]);
  }
}

void SceneBuffers::rewrite(const FixedBlocks& fixed, const VRObject& object) {
  rewrite(lit_, fixed.lit, object);
  rewrite(mapped_, fixed.mapped, object);
}

void SceneBuffers::upload(const Lightmap& lightmap) {
  if (lightmap.width() == 0) return;
  const GLuint texture = lightmap_.name();
  glTextureStorage2D(texture, 1, GL_RGBA16, lightmap.width(), lightmap.height());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTextureSubImage2D(texture, 0, 0, 0, lightmap.width(), lightmap.height(), GL_RGBA, GL_UNSIGNED_SHORT,
                      lightmap.texels().data());
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void SceneBuffers::bindMapped() const {
  glBindVertexArray(mapped_.array.name());
  glBindTextureUnit(1, lightmap_.name());
}

}  // namespace coherency
