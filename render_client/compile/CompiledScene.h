#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/math/Frustum.h"
#include "common/scene/Enclosure.h"
#include "common/scene/VRObject.h"
#include "render_client/compile/Bake.h"
#include "render_client/compile/CompileReport.h"
#include "render_client/compile/FixedBlocks.h"
#include "render_client/compile/MovingSurfaces.h"
#include "render_client/compile/SceneWatch.h"

namespace coherency {

/// An enclosure, and where it stands: T_world_object.
struct PlacedEnclosure {
  Enclosure enclosure;
  TransformMatrix t_world_object;
};

/// A tree of objects made ready for drawing (geometry compilation, paper, section III.C.1). What is fixed
/// stands in the world once and for all, with its light at its vertices or in a texture (FixedBlocks): no
/// object from the root down to it is declared Moving, or was found to move and is not declared. What moves
/// is a list, parents first: a frame walks no pointers and allocates nothing.
///
/// The tree is watched (SceneWatch): what moves may do so, materials may change everywhere, although light
/// keeps the colours it had, and what is declared Fixed refuses. Whatever else changes, an object's death
/// too, makes this stale: it is then to be replaced by a new one, and until then nothing but its destructor,
/// isStale(), root() and foundToMove() may be called.
class CompiledScene {
 public:
  /// Throws what buildMesh() throws, with the object's path, and what mobility() throws.
  CompiledScene(const VRObject& root, const Illumination& illumination, const BakeSettings& settings = {},
                const ObjectSet& found_to_move = {});
  CompiledScene(const CompiledScene&) = delete;
  CompiledScene& operator=(const CompiledScene&) = delete;

  bool isStale() const { return watch_.isStale(); }
  const VRObject* root() const { return watch_.root(); }  ///< null when it has died
  ObjectSet foundToMove() const { return watch_.foundToMove(); }
  const CompileReport& report() const { return report_; }

  const FixedBlocks& fixed() const { return *fixed_; }
  /// Of the objects that never move.
  const std::vector<PlacedEnclosure>& enclosures() const { return enclosures_; }
  const MovingSurfaces& moving() const { return moving_; }

  /// Reads the transforms of all that moves anew.
  void update();
  /// Gives fixed() the new materials of what was repainted since the last call, and calls repainted(object)
  /// for each.
  template <class Repainted>
  void repaint(const Repainted& repainted) {
    watch_.takeRepainted([&](const VRObject& object) {
      fixed_->repaint(object);
      repainted(object);
    });
  }
  const VRObject& object(const Drawable& drawable) const { return *nodes_[drawable.node].object; }
  /// T_world_node as of the last update().
  const TransformMatrix& worldTransform(const Drawable& drawable) const { return t_world_[drawable.node]; }
  /// About all of it, whatever its transform does to it (block clipping, paper, section III.C.2).
  Sphere worldSphere(const Drawable& drawable) const;
  /// The coarsest form that lies no farther from the finest than `error` m in the world.
  IndexRange coarsestWithin(double error, const Drawable& drawable) const;

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

  void addTree(const VRObject& root, const ObjectSet& found_to_move, FixedMesh& mesh);
  void addFixed(const VRObject& object, const TransformMatrix& t_world_object, FixedMesh& mesh);
  void addMovingTree(const VRObject& root, const TransformMatrix& t_world_parent, bool found);
  bool addMoving(const VRObject& object, std::uint32_t node);
  void report(const FixedMesh& mesh, const std::vector<std::uint32_t>& uncut);
  Coord3 middleOf(std::size_t first, std::uint32_t root) const;

  SceneWatch watch_;
  CompileReport report_;
  std::vector<Node> nodes_;  ///< of one without an object the transform stays
  std::vector<TransformMatrix> t_world_;
  std::vector<MovingRoot> roots_;
  std::optional<FixedBlocks> fixed_;
  std::vector<PlacedEnclosure> enclosures_;
  MovingSurfaces moving_;
  Bake bake_;
};

}  // namespace coherency
