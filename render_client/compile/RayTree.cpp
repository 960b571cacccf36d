#include "render_client/compile/RayTree.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/common.hpp>

namespace coherency {
namespace {

constexpr float kFar = 1e30F;  ///< finite, so that no infinity meets a zero
constexpr std::uint32_t kLeaf = 4;
constexpr int kBins = 12;
/// Levels after which parts are only halved: 16, and 16 more for 2^32 triangles, each with three children
/// that wait.
constexpr int kHalvedFrom = 16;

struct Bounds {
  glm::vec3 low{kFar};
  glm::vec3 high{-kFar};
  void add(const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void add(const Bounds& b) {
    low = glm::min(low, b.low);
    high = glm::max(high, b.high);
  }
  float halfArea() const {
    const glm::vec3 d = glm::max(high - low, glm::vec3(0.0F));
    return d.x * d.y + d.y * d.z + d.z * d.x;
  }
};

struct Item {
  Bounds bounds;
  glm::vec3 centre;
  std::uint32_t triangle;
};

struct Range {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint32_t size() const { return end - begin; }
};

/// Along one axis, in bins of equal width.
struct Binning {
  int axis;
  float low;
  float scale;
  int operator()(const Item& item) const { return static_cast<int>((item.centre[axis] - low) * scale); }
};

class Builder {
 public:
  explicit Builder(const std::vector<RayTriangle>& triangles) : triangles_(triangles) {
    items_.reserve(triangles.size());
    for (const RayTriangle& t : triangles) {
      Item item{{}, {}, static_cast<std::uint32_t>(items_.size())};
      for (const glm::vec3& corner : t) item.bounds.add(corner);
      item.centre = 0.5F * (item.bounds.low + item.bounds.high);
      items_.push_back(item);
    }
  }

  RayTree build() {
    addNode({0, static_cast<std::uint32_t>(items_.size())}, 0);
    return std::move(tree_);
  }

 private:
  Bounds boundsOf(Range range) const {
    Bounds bounds;
    for (std::uint32_t i = range.begin; i < range.end; ++i) bounds.add(items_[i].bounds);
    return bounds;
  }

  /// A node over the range, cut in two and its parts in two again; returns the node's number.
  std::int32_t addNode(Range range, int depth) {
    const std::size_t number = tree_.nodes.size();
    tree_.nodes.emplace_back();
    std::array<Range, 4> parts{range};
    std::size_t count = 1;
    for (int round = 0; round < 2; ++round)
      for (std::size_t i = 0, n = count; i < n; ++i)
        if (parts[i].size() > kLeaf) {
          const std::uint32_t middle = split(parts[i], depth);
          parts[count++] = {middle, parts[i].end};
          parts[i].end = middle;
        }
    RayTree::Node node{};
    for (std::size_t i = 0; i < 4; ++i) {
      const bool empty = i >= count || parts[i].size() == 0;
      const Bounds bounds = empty ? Bounds{} : boundsOf(parts[i]);
      for (int a = 0; a < 3; ++a) {
        node.bounds[0][a][i] = bounds.low[a];
        node.bounds[1][a][i] = bounds.high[a];
      }
      if (!empty)
        node.child[i] = parts[i].size() <= kLeaf ? ~addPacket(parts[i]) : addNode(parts[i], depth + 1);
    }
    tree_.nodes[number] = node;
    return static_cast<std::int32_t>(number);
  }

  std::int32_t addPacket(Range range) {
    RayTree::Packet packet{};  // what is left of it has no area, and is met by no ray
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const std::uint32_t lane = i - range.begin;
      const RayTriangle& t = triangles_[items_[i].triangle];
      packet.triangle[lane] = items_[i].triangle;
      for (int a = 0; a < 3; ++a) {
        packet.corner[a][lane] = t[0][a];
        packet.edge1[a][lane] = t[1][a] - t[0][a];
        packet.edge2[a][lane] = t[2][a] - t[0][a];
      }
    }
    tree_.packets.push_back(packet);
    return static_cast<std::int32_t>(tree_.packets.size() - 1);
  }

  /// Sorts the range into two parts; returns where the second begins.
  std::uint32_t split(Range range, int depth) {
    Bounds centres;
    for (std::uint32_t i = range.begin; i < range.end; ++i) centres.add(items_[i].centre);
    const glm::vec3 extent = centres.high - centres.low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const auto begin = items_.begin() + range.begin;
    const auto end = items_.begin() + range.end;
    auto middle = begin + (end - begin) / 2;
    if (extent[axis] > 0.0F && depth < kHalvedFrom) {
      const Binning bin{axis, centres.low[axis], kBins * (1.0F - 1e-5F) / extent[axis]};
      const int cut = cheapestCut(range, bin);
      middle = std::partition(begin, end, [&](const Item& item) { return bin(item) < cut; });
    } else {
      std::nth_element(begin, middle, end, [&](const Item& a, const Item& b) {
        return std::pair(a.centre[axis], a.triangle) < std::pair(b.centre[axis], b.triangle);
      });
    }
    return static_cast<std::uint32_t>(middle - items_.begin());
  }

  /// The bin before which to cut: where a ray may expect to be tested with the fewest triangles. The first
  /// and the last bin are never empty, so neither part is.
  int cheapestCut(Range range, const Binning& bin) const {
    std::array<Bounds, kBins> bounds;
    std::array<std::uint32_t, kBins> counts{};
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const auto b = static_cast<std::size_t>(bin(items_[i]));
      bounds[b].add(items_[i].bounds);
      ++counts[b];
    }
    std::array<float, kBins> cost{};  // of cutting before the bin
    const auto addCost = [&](std::size_t cut, const Bounds& part, std::uint32_t count) {
      cost[cut] += part.halfArea() * static_cast<float>(count);
    };
    Bounds part;
    std::uint32_t count = 0;
    for (std::size_t b = kBins - 1; b > 0; --b) {
      part.add(bounds[b]);
      addCost(b, part, count += counts[b]);
    }
    part = {};
    count = 0;
    for (std::size_t b = 1; b < kBins; ++b) {
      part.add(bounds[b - 1]);
      addCost(b, part, count += counts[b - 1]);
    }
    return static_cast<int>(std::min_element(cost.begin() + 1, cost.end()) - cost.begin());
  }

  const std::vector<RayTriangle>& triangles_;
  std::vector<Item> items_;
  RayTree tree_;
};

}  // namespace

RayTree buildRayTree(const std::vector<RayTriangle>& triangles) {
  return Builder(triangles).build();
}

}  // namespace coherency
