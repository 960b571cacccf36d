#pragma once

#include "render_client/compile/CompiledScene.h"
#include "render_client/draw/GlObjects.h"

namespace coherency {

/// A compiled scene's triangles on the GPU, uploaded once. Attribute 0 is the position; 1 the light of what
/// never moves and the normal of what does; 2 the drawable's number, which each draw command chooses by its
/// base instance (OpenGL 4.5 has no gl_BaseInstance).
class SceneBuffers {
 public:
  explicit SceneBuffers(const CompiledScene& scene);
  void bindFixed() const { glBindVertexArray(fixed_.array.name()); }
  void bindMoving() const { glBindVertexArray(moving_.array.name()); }

 private:
  struct Surfaces {
    VertexArray array;
    Buffer vertices;
    Buffer indices;
  };

  template <class Vertex>
  void upload(Surfaces& to, const coherency::Surfaces<Vertex>& from);

  Surfaces fixed_;
  Surfaces moving_;
  Buffer numbers_;
};

}  // namespace coherency
