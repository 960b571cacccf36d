#pragma once

#include "render_client/compile/MeshBuilder.h"

namespace coherency {

/// Bisects every edge longer than `longest_edge` (metres in the object's axes, > 0) until there is none, so
/// that light computed at the vertices is right between them too. Whether an edge is cut depends on its
/// length alone: triangles that share one cut it at the same vertex, and no gap opens. The surface stays what
/// it was.
void refine(Mesh& mesh, double longest_edge);

}  // namespace coherency
