#pragma once

#include <cstdint>
#include <vector>

#include "render_client/cull/ViewPyramid.h"

namespace coherency {

/// A hierarchy of spheres about things that never move, so that finding those in view costs as much as there
/// is in view, not as there is altogether. Built once: halves by the median along the axis on which the
/// centres lie farthest apart.
class SphereTree {
 public:
  explicit SphereTree(const std::vector<Sphere>& things);

  /// Appends the numbers of the things of which something may be in view; each once, in the tree's order.
  /// What is not finite always may.
  void findSeen(const ViewPyramids& views, std::vector<std::uint32_t>& seen) const;

 private:
  /// In depth-first order: a node's descendants follow it, up to `end`.
  struct Node {
    Sphere sphere;
    std::uint32_t end;           ///< the node after its last descendant
    std::uint32_t first, count;  ///< of the things below it, in numbers_
  };

  void build(const std::vector<Sphere>& things, std::uint32_t first, std::uint32_t count);
  Sphere around(const std::vector<Sphere>& things, std::uint32_t first, std::uint32_t count) const;

  std::vector<std::uint32_t> not_finite_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> numbers_;
  std::vector<Sphere> spheres_;  ///< in the order of numbers_
};

}  // namespace coherency
