#include "render_client/cull/SphereTree.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace coherency {
namespace {

constexpr std::uint32_t kFew = 4;  ///< things that are not worth a node of their own

int longestAxis(const glm::dvec3& extent) {
  if (extent.x >= extent.y && extent.x >= extent.z) return 0;
  return extent.y >= extent.z ? 1 : 2;
}

}  // namespace

SphereTree::SphereTree(const std::vector<Sphere>& things) {
  for (std::uint32_t i = 0; i < things.size(); ++i) {
    const bool finite = std::isfinite(things[i].radius) && std::isfinite(norm(things[i].centre));
    (finite ? numbers_ : not_finite_).push_back(i);
  }
  if (!numbers_.empty()) build(things, 0, static_cast<std::uint32_t>(numbers_.size()));
  spheres_.reserve(numbers_.size());
  for (const std::uint32_t number : numbers_) spheres_.push_back(things[number]);
}

void SphereTree::build(const std::vector<Sphere>& things, std::uint32_t first, std::uint32_t count) {
  const std::size_t node = nodes_.size();
  nodes_.push_back({around(things, first, count), 0, first, count});
  if (count > kFew) {
    glm::dvec3 low(things[numbers_[first]].centre.glm());
    glm::dvec3 high = low;
    for (std::uint32_t i = first; i < first + count; ++i) {
      low = glm::min(low, things[numbers_[i]].centre.glm());
      high = glm::max(high, things[numbers_[i]].centre.glm());
    }
    const int axis = longestAxis(high - low);
    const auto begin = numbers_.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
      const double at_a = things[a].centre.glm()[axis];
      const double at_b = things[b].centre.glm()[axis];
      return at_a != at_b ? at_a < at_b : a < b;
    });
    build(things, first, count / 2);
    build(things, first + count / 2, count - count / 2);
  }
  nodes_[node].end = static_cast<std::uint32_t>(nodes_.size());
}

/// About the middle of the spheres' box.
Sphere SphereTree::around(const std::vector<Sphere>& things, std::uint32_t first, std::uint32_t count) const {
  constexpr double kOutward = 1.0 + 1e-12;  // what rounding may have taken
  glm::dvec3 low(things[numbers_[first]].centre.glm());
  glm::dvec3 high = low;
  for (std::uint32_t i = first; i < first + count; ++i) {
    const Sphere& thing = things[numbers_[i]];
    low = glm::min(low, thing.centre.glm() - thing.radius);
    high = glm::max(high, thing.centre.glm() + thing.radius);
  }
  Sphere all{Coord3(0.5 * (low + high)), 0.0};
  for (std::uint32_t i = first; i < first + count; ++i) {
    const Sphere& thing = things[numbers_[i]];
    all.radius = std::max(all.radius, (norm(thing.centre - all.centre) + thing.radius) * kOutward);
  }
  return all;
}

void SphereTree::findSeen(const ViewPyramids& views, std::vector<std::uint32_t>& seen) const {
  seen.insert(seen.end(), not_finite_.begin(), not_finite_.end());
  for (std::uint32_t n = 0; n < nodes_.size();) {
    const Node& node = nodes_[n];
    const InView in_view = views.sees(node.sphere);
    const auto begin = numbers_.begin() + node.first;
    if (in_view == InView::All) {
      seen.insert(seen.end(), begin, begin + node.count);
    } else if (in_view == InView::Part && node.count <= kFew) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        if (views.sees(spheres_[i]) != InView::None) seen.push_back(numbers_[i]);
    } else if (in_view == InView::Part) {
      ++n;
      continue;
    }
    n = node.end;
  }
}

}  // namespace coherency
