#pragma once

#include "render_client/compile/CompiledScene.h"

namespace coherency {

/// A box with the world's axes, m.
struct WorldBox {
  Coord3 low;
  Coord3 high;
};

/// About all of a drawable as the scene now stands.
WorldBox worldBox(const CompiledScene& scene, const Drawable& drawable);
WorldBox worldBox(const Block& block);
/// Of the corner that is farthest from the point: a room's walls are farther than what stands before them.
double farthest(const WorldBox& box, const Coord3& point);
bool overlapFromAbove(const WorldBox& a, const WorldBox& b);

/// Where a drawable's vertices are: T with the world's axes and its origin at `eye`. The two far positions
/// are subtracted first, so that what is near the eye is exact however far both are from the world's origin.
glm::dmat4 fromEye(const Coord3& eye, const TransformMatrix& t_world_object, const Coord3& mesh_origin);

}  // namespace coherency
