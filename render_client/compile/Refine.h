#pragma once

#include "render_client/compile/MeshBuilder.h"

namespace coherency {

/// Halfway between two vertices of a surface.
MeshVertex middleOf(const MeshVertex& a, const MeshVertex& b);

/// Bisects every edge longer than `longest_edge` (metres in the object's axes, > 0) until there is none, so
/// that light computed at the vertices is right between them too. No gap opens (Subdivision.h). The surface,
/// and that of each coarser level, stays what it was.
void refine(Mesh& mesh, double longest_edge);

}  // namespace coherency
