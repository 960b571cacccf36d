#include "render_client/compile/NormalMatrix.h"

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

double handedness(const TransformMatrix& t) {
  const glm::dmat3 linear(t.glm());
  const double size = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
  if (!t.isFinite() || !(size > 0.0)) return 0.0;
  return glm::determinant(linear) / size;
}

}  // namespace coherency
