#include "render_client/compile/RayScene.h"

#include <cassert>
#include <cmath>

namespace coherency {

struct RayScene::Ray {
  Ray(const glm::vec3& from, const glm::vec3& direction, float reach_) : reach(reach_) {
    for (int a = 0; a < 3; ++a) {
      origin[a] = from[a] - Lanes{};
      along[a] = direction[a] - Lanes{};
      // Away from zero, so that its reciprocal is finite.
      const float divisor =
          std::abs(direction[a]) > 1e-20F ? direction[a] : std::copysign(1e-20F, direction[a]);
      inverse[a] = 1.0F / divisor - Lanes{};
      entry[a] = direction[a] < 0.0F ? 1 : 0;
    }
  }
  Lanes origin[3];
  Lanes along[3];
  Lanes inverse[3];
  int entry[3];  ///< the side of a box, low or high, by which the ray comes in
  float reach;
};

namespace {

/// The part of the ray within each of a node's four boxes; empty where `leave` is less than `enter`.
template <class Ray>
void clip(const RayTree::Node& node, const Ray& ray, Lanes& enter, Lanes& leave) {
  enter = Lanes{};
  leave = ray.reach - Lanes{};
  for (int a = 0; a < 3; ++a) {
    const Lanes in = (node.bounds[ray.entry[a]][a] - ray.origin[a]) * ray.inverse[a];
    const Lanes out = (node.bounds[1 - ray.entry[a]][a] - ray.origin[a]) * ray.inverse[a];
    enter = in > enter ? in : enter;
    leave = out < leave ? out : leave;
  }
}

/// Moeller & Trumbore 1997, four triangles at once; shortens the ray to what it meets. Triangles are a little
/// larger than they are, so that no ray slips through between two.
template <bool kAny, class Ray>
bool meet(const RayTree::Packet& packet, Ray& ray, RayHit& hit) {
  constexpr float kEdge = 1e-5F;
  const Lanes(&e1)[3] = packet.edge1;
  const Lanes(&e2)[3] = packet.edge2;
  const Lanes(&d)[3] = ray.along;
  const Lanes p[3] = {d[1] * e2[2] - d[2] * e2[1], d[2] * e2[0] - d[0] * e2[2], d[0] * e2[1] - d[1] * e2[0]};
  const Lanes det = e1[0] * p[0] + e1[1] * p[1] + e1[2] * p[2];
  const Lanes inverse = 1.0F / det;
  const Lanes s[3] = {ray.origin[0] - packet.corner[0], ray.origin[1] - packet.corner[1],
                      ray.origin[2] - packet.corner[2]};
  const Lanes u = (s[0] * p[0] + s[1] * p[1] + s[2] * p[2]) * inverse;
  const Lanes q[3] = {s[1] * e1[2] - s[2] * e1[1], s[2] * e1[0] - s[0] * e1[2], s[0] * e1[1] - s[1] * e1[0]};
  const Lanes v = (d[0] * q[0] + d[1] * q[1] + d[2] * q[2]) * inverse;
  const Lanes t = (e2[0] * q[0] + e2[1] * q[1] + e2[2] * q[2]) * inverse;
  // Where there is no area, all of these are NaN and none of the comparisons holds.
  const auto met = (u >= -kEdge) & (v >= -kEdge) & (u + v <= 1.0F + kEdge) & (t > 0.0F) & (t < ray.reach);
  bool any = false;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    if (met[lane] == 0 || !(t[lane] < ray.reach)) continue;
    if (kAny) return true;
    any = true;
    ray.reach = t[lane];
    hit = {t[lane], packet.triangle[lane], det[lane] < 0.0F};
  }
  return any;
}

}  // namespace

template <bool kAny>
bool RayScene::trace(Ray& ray, RayHit& hit) const {
  struct Waiting {
    float distance;
    std::int32_t child;
  };
  std::array<Waiting, RayTree::kMaxWaiting> stack;
  std::size_t top = 0;
  stack[top++] = {0.0F, 0};
  bool any = false;
  while (top > 0) {
    // Read one by one, as they were written: read in one, they would have to wait for both to reach the
    // cache.
    if (stack[--top].distance >= ray.reach) continue;
    const std::int32_t at = stack[top].child;
    if (at < 0) {
      const std::int32_t packet = ~at;
      any = meet<kAny>(tree_.packets[static_cast<std::size_t>(packet)], ray, hit) || any;
      if (!kAny || !any) continue;
      hit.triangle = static_cast<std::uint32_t>(packet);
      return true;
    }
    const RayTree::Node& node = tree_.nodes[static_cast<std::size_t>(at)];
    Lanes enter;
    Lanes leave;
    clip(node, ray, enter, leave);
    const std::size_t bottom = top;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!(enter[i] <= leave[i])) continue;
      assert(top < RayTree::kMaxWaiting);
      std::size_t place = top++;
      if (!kAny)  // the nearest on top
        for (; place > bottom && stack[place - 1].distance < enter[i]; --place)
          stack[place] = stack[place - 1];
      stack[place] = {enter[i], node.child[i]};
    }
  }
  return any;
}

bool RayScene::blocked(const glm::vec3& from, const glm::vec3& to, std::int32_t& blocker) const {
  Ray ray(from, to - from, 1.0F);
  RayHit hit;
  if (blocker != kNoBlocker && meet<true>(tree_.packets[static_cast<std::size_t>(blocker)], ray, hit))
    return true;
  if (!trace<true>(ray, hit)) return false;
  blocker = static_cast<std::int32_t>(hit.triangle);
  return true;
}

bool RayScene::nearest(const glm::vec3& from, const glm::vec3& direction, float reach, RayHit& hit) const {
  Ray ray(from, direction, reach);
  return trace<false>(ray, hit);
}

}  // namespace coherency
