#pragma once

#include "render_client/compile/FixedBlocks.h"
#include "render_client/draw/StreamBuffer.h"

namespace coherency {

/// What one shader draws in a frame, as the GPU reads it: one call a view, and one more where mirrored
/// objects, whose triangles turn the other way round, are among them.
class DrawCommands {
 public:
  explicit DrawCommands(std::size_t capacity);

  void begin();
  /// `number` reaches the vertex shader. No more than `capacity`.
  void add(const IndexRange& range, std::size_t number, bool mirrored = false);
  std::size_t size() const { return upright_ + mirrored_; }
  std::size_t triangleCount() const { return triangles_; }
  /// With the scene's buffers bound; culling as the caller has set it. Leaves GL_CCW as the front face.
  void draw() const;

 private:
  struct Command {  // as glMultiDrawElementsIndirect has it
    GLuint count;
    GLuint instance_count;
    GLuint first_index;
    GLint base_vertex;
    GLuint base_instance;
  };

  std::size_t capacity_;
  StreamBuffer buffer_;
  Command* commands_ = nullptr;  ///< upright ones from the front, mirrored ones from the back
  std::size_t upright_ = 0;
  std::size_t mirrored_ = 0;
  std::size_t triangles_ = 0;
};

}  // namespace coherency
