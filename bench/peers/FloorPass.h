#pragma once

#include <cstdint>
#include <vector>

#include "render_client/draw/GlObjects.h"

namespace coherency {

struct DrawCommand {  // as glMultiDrawElementsIndirect has it
  GLuint count;
  GLuint instance_count;
  GLuint first_index;
  GLint base_vertex;
  GLuint base_instance;
};

/// How a vertex's second attribute lies in it, and its material, four bytes, where it has one; the first
/// attribute is its position, three floats at its beginning.
struct VertexLayout {
  GLsizei stride;
  GLint size;
  GLenum type;
  GLboolean normalised;
  GLuint offset;
  GLuint material;  ///< offset; 0: none
};

/// What one call draws. No two commands have the same base instance, which is less than `instances`.
struct FloorBatch {
  std::vector<std::uint32_t> indices;
  std::vector<DrawCommand> commands;
};

/// One shader's triangles, drawn by one call. Attribute 2 is the command's base instance.
class FloorPass {
 public:
  /// `marking` notes down what is drawn (kMarkingFragmentShader) and has the same places for it.
  FloorPass(Program program, Program marking, const VertexLayout& layout, std::size_t instances);

  template <class T>
  static void fill(const Buffer& buffer, const std::vector<T>& data) {
    fill(buffer, data.data(), data.size() * sizeof(T));
  }
  void set(FloorBatch batch);
  const FloorBatch& batch() const { return batch_; }
  void draw() const { drawWith(program); }

  /// Draws, and marks the triangles of which a fragment passed the depth test; forgets earlier marks.
  void mark() const;
  /// Its batch without what the last mark() did not mark.
  FloorBatch marked() const;

  Program program;
  Program marking;
  Buffer vertices;
  Buffer objects;  ///< at binding 0, for shaders that read some

 private:
  static void fill(const Buffer& buffer, const void* data, std::size_t bytes);
  void drawWith(const Program& used) const;

  VertexArray array_;
  Buffer numbers_;
  Buffer indices_;
  Buffer commands_;
  Buffer first_triangles_;  ///< by base instance
  Buffer marks_;            ///< by triangle
  FloorBatch batch_;
  std::size_t instances_;
};

}  // namespace coherency
