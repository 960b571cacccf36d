#include "render_client/draw/EyeSpace.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace coherency {

glm::dmat4 eyeFromMesh(const TransformMatrix& t_world_eye, const TransformMatrix& t_world_object,
                       const Coord3& mesh_origin) {
  const glm::dmat3 r_eye_world = glm::transpose(glm::dmat3(t_world_eye.glm()));
  const Coord3 offset = t_world_object.origin() - t_world_eye.origin() + t_world_object.vector(mesh_origin);
  glm::dmat4 result(r_eye_world * glm::dmat3(t_world_object.glm()));
  result[3] = glm::dvec4(r_eye_world * offset.glm(), 1.0);
  return result;
}

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
