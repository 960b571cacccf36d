#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/math/Frustum.h"
#include "common/scene/Enclosure.h"
#include "common/scene/VRObject.h"
#include "render_client/compile/Bake.h"
#include "render_client/compile/FixedBlocks.h"
#include "render_client/compile/MeshBuilder.h"

namespace coherency {

/// An object that moves and shows faces: where its triangles are, and whose they are.
struct Drawable {
  IndexRange range;
  const FaceSet* faces;  ///< its material may change at any time, its shape may not
  std::uint32_t node;    ///< for CompiledScene::worldTransform()
  Coord3 origin;         ///< of its vertices, in the node's frame: about the middle of its box
  Coord3 half_extent;    ///< of a box about them, in the node's axes
  double radius;         ///< of a sphere about `origin` that holds them, in the node's frame
  std::uint32_t root;    ///< its place in CompiledScene::movingRoots()
};

/// What moves as a whole: an object with the attribute Moving, and all below it that shows faces.
struct MovingRoot {
  std::uint32_t node;
  Coord3 middle;  ///< in the node's frame: a little above that of the box about all, as it was compiled
};

/// All triangles of what moves in one buffer.
struct MovingSurfaces {
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< from a drawable's first vertex
  std::vector<Drawable> drawables;
};

/// An enclosure, and where it stands: T_world_object.
struct PlacedEnclosure {
  Enclosure enclosure;
  TransformMatrix t_world_object;
};

/// A tree of objects made ready for drawing (geometry compilation, paper, section III.C.1). What never moves,
/// no object from the root down to it having the attribute Moving, stands in the world once and for all, with
/// its light at its vertices or in a texture (FixedBlocks). What moves is a list, parents first: a frame
/// walks no pointers and allocates nothing. The tree must outlive this and keep its structure; transforms may
/// change where it is marked so, materials everywhere, although light keeps the colours it had.
class CompiledScene {
 public:
  /// Throws what buildMesh() throws, with the object's path.
  CompiledScene(const VRObject& root, const Illumination& illumination, const BakeSettings& settings = {});

  const FixedBlocks& fixed() const { return *fixed_; }
  /// Of the objects that never move.
  const std::vector<PlacedEnclosure>& enclosures() const { return enclosures_; }
  const MovingSurfaces& moving() const { return moving_; }

  /// Reads the transforms of all that moves anew.
  void update();
  const VRObject& object(const Drawable& drawable) const { return *nodes_[drawable.node].object; }
  /// T_world_node as of the last update().
  const TransformMatrix& worldTransform(const Drawable& drawable) const { return t_world_[drawable.node]; }
  /// About all of it, whatever its transform does to it (block clipping, paper, section III.C.2).
  Sphere worldSphere(const Drawable& drawable) const;

  const std::vector<MovingRoot>& movingRoots() const { return roots_; }
  /// Where one of them is, as of the last update(): a function of its transform alone, whatever its joints.
  Coord3 place(const MovingRoot& root) const { return t_world_[root.node].point(root.middle); }
  /// How much of a lamp is in sight from about a place in the world (LightBaker::inSight()).
  float inSight(std::size_t lamp, const Coord3& place) const;

 private:
  struct Node {
    const VRObject* object;
    std::uint32_t parent;
  };

  void addTree(const VRObject& root, FixedMesh& mesh);
  void addMovingTree(const VRObject& root, const TransformMatrix& t_world_parent);
  void addMoving(const VRObject& object, std::uint32_t node);
  Coord3 middleOf(std::size_t first, std::uint32_t root) const;

  std::vector<Node> nodes_;  ///< of one without an object the transform stays
  std::vector<TransformMatrix> t_world_;
  std::vector<MovingRoot> roots_;
  std::optional<FixedBlocks> fixed_;
  std::vector<PlacedEnclosure> enclosures_;
  MovingSurfaces moving_;
  Bake bake_;
};

}  // namespace coherency
