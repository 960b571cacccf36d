#pragma once

#include <cstdint>
#include <vector>

#include "common/scene/VRObject.h"
#include "render_client/compile/MeshBuilder.h"

namespace coherency {

/// One object that shows faces: where its triangles are, and whose they are.
struct Drawable {
  const FaceSet* faces;  ///< its material may change at any time, its shape may not
  std::uint32_t node;    ///< for CompiledScene::worldTransform()
  Coord3 origin;         ///< of its vertices, in the object's frame (Mesh::origin): the middle of its box
  Coord3 half_extent;    ///< of the box about them, in the object's axes
  std::uint32_t first_index;  ///< triangles dense enough to be lit at their vertices
  std::uint32_t index_count;
  std::uint32_t first_plain;  ///< the same surface in no more triangles than its shape needs: for shadows
  std::uint32_t plain_count;
  std::uint32_t first_vertex;
};

/// A tree of objects made ready for drawing: all shapes as triangles in one buffer, and the tree as a list
/// with parents first, so that a frame neither walks pointers recursively nor allocates. The tree must
/// outlive this and keep its structure; its transforms may change.
class CompiledScene {
 public:
  /// Throws what buildMesh() throws, with the object's path.
  explicit CompiledScene(const VRObject& root);

  const std::vector<MeshVertex>& vertices() const { return vertices_; }
  const std::vector<std::uint32_t>& indices() const { return indices_; }
  const std::vector<Drawable>& drawables() const { return drawables_; }

  /// Reads all transforms anew.
  void update();
  /// T_world_object as of the last update().
  const TransformMatrix& worldTransform(const Drawable& drawable) const { return t_world_[drawable.node]; }

 private:
  static constexpr std::uint32_t kNoParent = UINT32_MAX;
  struct Node {
    const VRObject* object;
    std::uint32_t parent;
  };

  void addDrawable(const VRObject& object, std::uint32_t node);

  std::vector<Node> nodes_;
  std::vector<TransformMatrix> t_world_;
  std::vector<Drawable> drawables_;
  std::vector<MeshVertex> vertices_;
  std::vector<std::uint32_t> indices_;
};

}  // namespace coherency
