#pragma once

#include <cstdint>

#include <glm/mat3x3.hpp>

#include "common/math/TransformMatrix.h"

namespace coherency {

/// Takes normals along with a transform, mirrored ones too; its scale means nothing. Precondition:
/// det(linear) is not 0.
glm::dmat3 normalMatrix(const glm::dmat3& linear);

/// What a transform does to a box. Of what is flat nothing is drawn: where the determinant is less than 1e-9
/// of the product of the columns' lengths, or anything is not finite.
enum class Turn : std::uint8_t { Upright, Mirrored, Flat };
Turn turnOf(const TransformMatrix& t);

}  // namespace coherency
