#include "render_client/compile/NormalMatrix.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace coherency {

glm::dmat3 normalMatrix(const glm::dmat3& linear) {
  // The cofactor matrix is det * inverse transpose, without the division.
  const glm::dmat3 cofactor(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                            glm::cross(linear[0], linear[1]));
  const double det = glm::dot(linear[0], cofactor[0]);
  const double size = glm::length(cofactor[0]) + glm::length(cofactor[1]) + glm::length(cofactor[2]);
  return cofactor * ((det < 0.0 ? -1.0 : 1.0) / size);
}

Turn turnOf(const TransformMatrix& t) {
  constexpr double kFlat = 1e-9;
  const glm::dmat3 linear(t.glm());
  const double det = glm::determinant(linear);
  const double size =
      glm::dot(linear[0], linear[0]) * glm::dot(linear[1], linear[1]) * glm::dot(linear[2], linear[2]);
  const bool finite = std::isfinite(size) && isFinite(t.origin());
  if (!finite || !(det * det >= kFlat * kFlat * size) || !(size > 0.0)) return Turn::Flat;
  return det < 0.0 ? Turn::Mirrored : Turn::Upright;
}

}  // namespace coherency
