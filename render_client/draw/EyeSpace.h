#pragma once

#include <glm/mat4x4.hpp>

#include "common/math/TransformMatrix.h"

namespace coherency {

/// T_eye_mesh for vertices relative to `mesh_origin` in the object's frame. The two far positions are
/// subtracted first, so that what is near the eye is exact however far both are from the world's origin.
/// Precondition: t_world_eye is rigid.
glm::dmat4 eyeFromMesh(const TransformMatrix& t_world_eye, const TransformMatrix& t_world_object,
                       const Coord3& mesh_origin);

/// Takes normals along with a transform, mirrored ones too; its scale means nothing. Precondition:
/// det(linear) is not 0.
glm::dmat3 normalMatrix(const glm::dmat3& linear);

/// Determinant of the 3x3 part over the product of its columns' lengths: 1 or -1 for a (mirrored) box, near 0
/// for a flattened one; 0 where anything is not finite or a column is zero.
double handedness(const TransformMatrix& t);

}  // namespace coherency
