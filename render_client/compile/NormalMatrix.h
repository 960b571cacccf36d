#pragma once

#include <glm/mat3x3.hpp>

#include "common/math/TransformMatrix.h"

namespace coherency {

/// Takes normals along with a transform, mirrored ones too; its scale means nothing. Precondition:
/// det(linear) is not 0.
glm::dmat3 normalMatrix(const glm::dmat3& linear);

/// Determinant of the 3x3 part over the product of its columns' lengths: 1 or -1 for a (mirrored) box, near 0
/// for a flattened one; 0 where anything is not finite or a column is zero.
double handedness(const TransformMatrix& t);

/// Of what is flatter than this nothing is drawn.
inline constexpr double kFlat = 1e-9;

}  // namespace coherency
