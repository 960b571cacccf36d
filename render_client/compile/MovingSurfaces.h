#pragma once

#include <cstdint>
#include <vector>

#include "render_client/compile/FixedBlocks.h"
#include "render_client/compile/MeshBuilder.h"

namespace coherency {

/// An object that moves and shows faces: where its triangles are, and whose they are.
struct Drawable {
  IndexRange range;
  const FaceSet* faces;             ///< its material may change at any time, its shape may not
  std::uint32_t node;               ///< for CompiledScene::worldTransform()
  Coord3 origin;                    ///< of its vertices, in the node's frame: about the middle of its box
  Coord3 half_extent;               ///< of a box about them, in the node's axes
  double radius;                    ///< of a sphere about `origin` that holds them, in the node's frame
  std::uint32_t root;               ///< its place in CompiledScene::movingRoots()
  std::vector<LevelRange> coarser;  ///< errors in the node's frame
};

/// What moves as a whole: an object that is declared Moving, or was found to move, and all below it that
/// shows faces.
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

}  // namespace coherency
