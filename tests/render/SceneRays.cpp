#include "tests/render/SceneRays.h"

#include <glm/geometric.hpp>

#include "render_client/compile/FixedMesh.h"

namespace coherency {
namespace {

constexpr float kFar = 1e4F;     // m
constexpr float kApart = 2e-5F;  // m

/// Towards its front: of a back and a front in one plane, as of a clock that hangs on a wall, the front is
/// met first.
RayTriangle risen(RayTriangle triangle) {
  const glm::vec3 area = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const float length = glm::length(area);
  if (length > 0.0F)
    for (glm::vec3& corner : triangle) corner += (kApart / length) * area;
  return triangle;
}

}  // namespace

SceneRays::SceneRays(const std::vector<const VRObject*>& roots) {
  FixedMesh mesh;
  for (const VRObject* root : roots)
    forEachObject(*root, root->globalTransform(),
                  [&](const VRObject& object, const TransformMatrix& t_world_object) {
                    mesh.add(object, t_world_object);
                  });
  const auto corner = [&](std::size_t i) {
    const std::uint32_t v = mesh.indices[i];
    return glm::vec3(mesh.objectOf(v).origin.glm() + glm::dvec3(mesh.vertices[v].position));
  };
  std::vector<RayTriangle> triangles;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    triangles.push_back(risen({corner(i), corner(i + 1), corner(i + 2)}));
    owners_.push_back(mesh.objectOf(mesh.indices[i]).object);
  }
  rays_ = RayScene(triangles);
}

SceneRays::Met SceneRays::first(const Coord3& from, const Coord3& direction, double from_distance) const {
  constexpr double kBeyond = 1e-5;  // m: what was met is not to be met again
  const glm::vec3 along(direction.glm());
  double gone = from_distance;
  RayHit hit;
  while (rays_.nearest(glm::vec3((from + gone * direction).glm()), along, kFar, hit)) {
    gone += hit.distance;
    if (!hit.from_behind) return {owners_[hit.triangle], gone};
    gone += kBeyond;
  }
  return {};
}

}  // namespace coherency
