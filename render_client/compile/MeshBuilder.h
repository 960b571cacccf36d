#pragma once

#include <cstdint>
#include <vector>

#include "common/scene/FaceSet.h"

namespace coherency {

/// As it lies in the vertex buffer.
struct MeshVertex {
  float position[3];  ///< m, object's axes, relative to Mesh::origin
  float normal[3];    ///< unit length, outward
};

/// A level of detail (DetailLevel) as triangles over its mesh's vertices.
struct MeshLevel {
  std::vector<std::uint32_t> indices;
  double error;  ///< m, in the object's axes
};

/// A shape as triangles. Vertices are float but relative to `origin`, the middle of the shape's bounding box,
/// so that a shape far from its object's frame keeps its precision.
struct Mesh {
  Coord3 origin;  ///< m, in the object's frame
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise seen from outside
  std::vector<MeshLevel> coarser;      ///< as FaceSet::coarser
};

/// Triangulates convex faces as fans. Normals are the faces' own, or, for a smooth set, the mean over the
/// faces that meet at the vertex at less than the crease angle, weighted by their corner angles (Thuermer &
/// Wuethrich 1998). Faces without area show nothing and are left out. A corner of a coarser face is,
/// of the vertices made for its place, the one whose normal is nearest to the face's own, so that side and
/// cap stay apart. Throws std::invalid_argument naming the face where an index has no vertex, or the level
/// whose error does not rise.
Mesh buildMesh(const FaceSet& faces);

}  // namespace coherency
