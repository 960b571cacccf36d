#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/math/Frustum.h"
#include "common/scene/FaceSet.h"
#include "common/scene/VRObject.h"
#include "render_client/compile/FixedMesh.h"
#include "render_client/compile/IndexRange.h"
#include "render_client/compile/Lightmap.h"

namespace coherency {

/// What never moves is drawn block by block: objects that lie together, with a local origin, so that vertices
/// are exact in float wherever in the world they are.
struct Block {
  IndexRange range;
  Coord3 origin;                    ///< of its vertices, in the world: the middle of the box about them
  Coord3 half_extent;               ///< of that box, world's axes, m
  double radius;                    ///< of the sphere about them, m
  bool shaded;                      ///< what moves could keep light away from some of it
  std::vector<LevelRange> coarser;  ///< of the whole block
};

/// An object's own triangles within a block, or within one of its coarser levels: then it has no vertices of
/// its own.
struct BlockPart {
  const VRObject* object;
  std::uint32_t block;
  std::uint32_t vertex_count;
  IndexRange range;  ///< `first_vertex`: of its vertices; indices count from the block's
};

/// Square roots of a material's colour, and its emission, as shares of 255.
struct PackedMaterial {
  std::uint8_t share[4];
};
PackedMaterial materialOf(const Material& material);

/// As they lie in the vertex buffer. Positions: m, world's axes, from the block's origin.
struct LitVertex {
  float position[3];
  PackedLight light;
  PackedMaterial material;
};
struct MappedVertex {
  float position[3];
  struct {
    float u, v;
  } place;  ///< in the lightmap
  PackedMaterial material;
};

template <class Vertex>
struct BlockSurfaces {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<Block> blocks;
  std::vector<BlockPart> parts;          ///< as they lie in the buffers
  std::vector<std::uint32_t> by_object;  ///< places in `parts`, ordered by object (std::less)

  /// Places in `parts`.
  std::span<const std::uint32_t> partsOf(const VRObject& object) const;
};

/// All that never moves, ready for the GPU (geometry compilation, paper, section III.C.1): what is flat and
/// large with its light in a texture, everything else with its light at its vertices. Of a scene large enough
/// blocks have about kBlockTriangles triangles, and objects further apart than kBlockSize do not share one.
struct FixedBlocks {
  static constexpr std::size_t kBlockTriangles = 256;
  static constexpr double kBlockSize = 4.0;  ///< m
  /// A block's coarser levels have of each object the coarsest that lies no farther off than this, m.
  static constexpr double kLevelErrors[] = {0.002, 0.008, 0.032};

  BlockSurfaces<LitVertex> lit;
  BlockSurfaces<MappedVertex> mapped;
  Lightmap lightmap;
  std::size_t object_count;  ///< that show faces

  /// The mesh as cut, with the light of its vertices; its triangles as they were before; and how fine a
  /// lightmap may be, m.
  FixedBlocks(const FixedMesh& mesh, const std::vector<std::uint32_t>& uncut,
              const std::vector<SurfaceLight>& light, double finest);

  /// Gives the object's vertices the material that it has now. The light, of other surfaces too, stays as it
  /// was.
  void repaint(const VRObject& object);
};

}  // namespace coherency
