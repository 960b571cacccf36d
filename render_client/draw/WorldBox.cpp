#include "render_client/draw/WorldBox.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace coherency {

WorldBox worldBox(const CompiledScene& scene, const Drawable& drawable) {
  const TransformMatrix& t_world_object = scene.worldTransform(drawable);
  const glm::dmat3 m(t_world_object.glm());
  const glm::dvec3 half = drawable.half_extent.glm();
  const Coord3 reach(glm::abs(m[0]) * half.x + glm::abs(m[1]) * half.y + glm::abs(m[2]) * half.z);
  const Coord3 middle = t_world_object.point(drawable.origin);
  return {middle - reach, middle + reach};
}

WorldBox worldBox(const Block& block) {
  return {block.origin - block.half_extent, block.origin + block.half_extent};
}

double farthest(const WorldBox& box, const Coord3& point) {
  return glm::length(glm::max(glm::abs((box.low - point).glm()), glm::abs((box.high - point).glm())));
}

bool overlapFromAbove(const WorldBox& a, const WorldBox& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.z < b.high.z && b.low.z < a.high.z;
}

glm::dmat4 fromEye(const Coord3& eye, const TransformMatrix& t_world_object, const Coord3& mesh_origin) {
  const Coord3 offset = t_world_object.origin() - eye + t_world_object.vector(mesh_origin);
  glm::dmat4 result(glm::dmat3(t_world_object.glm()));
  result[3] = glm::dvec4(offset.glm(), 1.0);
  return result;
}

}  // namespace coherency
