#pragma once

#include "render_client/compile/CompiledScene.h"
#include "render_client/draw/GlObjects.h"

namespace coherency {

/// A compiled scene's triangles on the GPU, uploaded once, but for materials. Attribute 0 is the position; 1
/// the light of what never moves, or its place in the lightmap, and the normal of what moves; 2 the number
/// that each draw command gives by its base instance (OpenGL 4.5 has no gl_BaseInstance); 3 the material of
/// what never moves.
class SceneBuffers {
 public:
  explicit SceneBuffers(const CompiledScene& scene);
  /// Uploads the vertices of an object that is fixed anew.
  void rewrite(const FixedBlocks& fixed, const VRObject& object);
  void bindLit() const { glBindVertexArray(lit_.array.name()); }
  /// With the lightmap as texture 1.
  void bindMapped() const;
  void bindMoving() const { glBindVertexArray(moving_.array.name()); }

 private:
  struct Surfaces {
    VertexArray array;
    Buffer vertices;
    Buffer indices;
  };

  template <class Vertex>
  void upload(Surfaces& to, const std::vector<Vertex>& vertices, const std::vector<std::uint32_t>& indices);
  void upload(const Lightmap& lightmap);
  template <class Vertex>
  static void rewrite(Surfaces& to, const BlockSurfaces<Vertex>& from, const VRObject& object);

  Surfaces lit_;
  Surfaces mapped_;
  Surfaces moving_;
  Buffer numbers_;
  Texture lightmap_;
};

}  // namespace coherency
