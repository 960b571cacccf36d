#pragma once

#include "render_client/compile/CompiledScene.h"
#include "render_client/draw/GlObjects.h"

namespace coherency {

/// A compiled scene's triangles on the GPU, uploaded once. Attribute 0 is the position, 1 the normal, 2 the
/// drawable's number, which each draw command chooses by its base instance (OpenGL 4.5 has no
/// gl_BaseInstance).
class SceneBuffers {
 public:
  explicit SceneBuffers(const CompiledScene& scene);
  void bind() const { glBindVertexArray(vertex_array_.name()); }

 private:
  Buffer vertices_;
  Buffer indices_;
  Buffer numbers_;
  VertexArray vertex_array_;
};

}  // namespace coherency
