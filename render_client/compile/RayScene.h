#pragma once

#include "render_client/compile/RayTree.h"

namespace coherency {

/// Where a ray first meets a triangle.
struct RayHit {
  float distance = 0.0F;       ///< in lengths of the ray's direction
  std::uint32_t triangle = 0;  ///< its place in what the RayScene was made of
  bool from_behind = false;    ///< the ray came from inside
};

/// Triangles to send rays through: what is in sight of what. Both sides of a triangle stop a ray, and two
/// that share an edge let none through between them. Coordinates are m from an origin of the caller's choice,
/// near enough for float. Never changes: any number of threads may ask at once.
class RayScene {
 public:
  explicit RayScene(const std::vector<RayTriangle>& triangles = {}) : tree_(buildRayTree(triangles)) {}

  bool empty() const { return tree_.packets.empty(); }
  /// Whether anything lies between the two points. What did for the last ray is tried first for the next, as
  /// it often does for that too: pass the same `blocker`, at first kNoBlocker, for rays that have much in
  /// common.
  bool blocked(const glm::vec3& from, const glm::vec3& to, std::int32_t& blocker) const;
  bool blocked(const glm::vec3& from, const glm::vec3& to) const {
    std::int32_t blocker = kNoBlocker;
    return blocked(from, to, blocker);
  }
  static constexpr std::int32_t kNoBlocker = -1;
  /// The first triangle met within `reach` lengths of `direction`; false: none.
  bool nearest(const glm::vec3& from, const glm::vec3& direction, float reach, RayHit& hit) const;

 private:
  struct Ray;
  template <bool kAny>
  bool trace(Ray& ray, RayHit& hit) const;  // kAny: whichever; hit.triangle is its packet

  RayTree tree_;
};

}  // namespace coherency
