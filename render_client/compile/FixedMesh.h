#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "common/math/TransformMatrix.h"
#include "common/scene/FaceSet.h"
#include "common/scene/VRObject.h"
#include "render_client/compile/MeshBuilder.h"

namespace coherency {

/// Things that shine by themselves, by half or more (Material::emission), keep no light away: a lamp may
/// stand inside its own fitting.
inline constexpr double kShines = 0.5;
/// Nor do rods and rails, no thicker than this both ways across: lamps are wide, and what they leave of such
/// a shadow is finer than the mesh that would have to show it.
inline constexpr double kRod = 0.07;  // m

/// What there is to see of an object itself.
enum class Shows : std::uint8_t {
  Faces,
  NoFaces,  ///< it groups others
  NoArea,   ///< its faces are points and lines
  Flat,     ///< its transform squashes it (kFlat)
};

/// An object that never moves and shows faces.
struct FixedObject {
  const VRObject* object;
  Coord3 origin;        ///< of its vertices, m, in the world
  double longest_edge;  ///< m; its edges are cut to it, so that light can be computed at the vertices;
                        ///< infinite: never
  bool rod;
  std::vector<MeshLevel> coarser;  ///< over the mesh's vertices; errors in the world
};

struct FixedVertex {
  glm::vec3 position;  ///< m, world's axes, from its object's origin
  glm::vec3 normal;    ///< unit length, world's axes
  std::uint32_t object;
};

/// The surfaces of all that never moves, as triangles standing in the world (geometry compilation, paper,
/// section III.C.1). Mirrored shapes are turned right.
struct FixedMesh {
  std::vector<FixedObject> objects;
  std::vector<FixedVertex> vertices;  ///< object by object
  std::vector<std::uint32_t>
      indices;  ///< three a triangle, counter-clockwise seen from outside; object by object

  /// Adds nothing where there is nothing to see. Throws what buildMesh() throws, with the
  /// object's path.
  Shows add(const VRObject& object, const TransformMatrix& t_world_object);

  const FixedObject& objectOf(std::uint32_t vertex) const { return objects[vertices[vertex].object]; }
};

/// buildMesh() of the object's faces; what it throws has the object's path before it.
Mesh meshOf(const VRObject& object);

}  // namespace coherency
