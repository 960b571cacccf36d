#include "render_client/compile/Subdivision.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

namespace coherency {
namespace {

using Cell = std::array<std::int64_t, 3>;

/// Numbers things from 0 so that equal ones have one number; in the order of their size.
template <class Key>
std::vector<std::uint32_t> numbered(const std::vector<Key>& keys) {
  std::vector<std::uint32_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
  std::vector<std::uint32_t> numbers(keys.size());
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && keys[order[i - 1]] < keys[order[i]]) ++number;
    numbers[order[i]] = number;
  }
  return numbers;
}

std::vector<std::uint32_t> weldedPoints(const std::vector<glm::dvec3>& vertices, double weld) {
  std::vector<Cell> cells;
  cells.reserve(vertices.size());
  for (const glm::dvec3& v : vertices)
    cells.push_back({std::llround(v.x / weld), std::llround(v.y / weld), std::llround(v.z / weld)});
  return numbered(cells);
}

}  // namespace

Subdivision::Subdivision(const std::vector<glm::dvec3>& vertices, const std::vector<std::uint32_t>& indices,
                         double weld)
    : points_(vertices.size()), point_of_(weldedPoints(vertices, weld)) {
  for (std::size_t v = 0; v < vertices.size(); ++v) points_[point_of_[v]] = vertices[v];
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  for (std::size_t i = 0; i < indices.size(); ++i)
    ends.emplace_back(std::minmax(point_of_[indices[i]], point_of_[indices[i % 3 == 2 ? i - 2 : i + 1]]));
  const std::vector<std::uint32_t> edge_of = numbered(ends);
  std::vector<bool> made(ends.size(), false);
  edges_.resize(ends.empty() ? 0 : 1U + *std::max_element(edge_of.begin(), edge_of.end()));
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (made[edge_of[i]]) continue;
    made[edge_of[i]] = true;
    const glm::dvec3 along = points_[ends[i].second] - points_[ends[i].first];
    edges_[edge_of[i]] = {{ends[i].first, ends[i].second}, glm::dot(along, along)};
  }
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Triangle t{{indices[i], indices[i + 1], indices[i + 2]},
                     {edge_of[i], edge_of[i + 1], edge_of[i + 2]}};
    for (std::size_t c = 0; c < 3; ++c)
      addSide(t.edge[c], t.vertex[c], t.vertex[(c + 1) % 3], t.vertex[(c + 2) % 3]);
    triangles_.push_back(t);
  }
}

std::uint32_t Subdivision::addEdge(std::uint32_t p, std::uint32_t q) {
  const glm::dvec3 along = points_[q] - points_[p];
  edges_.push_back({{p, q}, glm::dot(along, along)});
  return static_cast<std::uint32_t>(edges_.size() - 1);
}

/// Where the number of the edge's side between the two vertices stands, or is to stand; `a` at its first
/// point.
std::uint32_t& Subdivision::sideOf(std::uint32_t edge, std::uint32_t a, std::uint32_t b) {
  std::uint32_t* at = &edges_[edge].side;
  while (*at != kNone && (sides_[*at].a != a || sides_[*at].b != b)) at = &sides_[*at].next;
  return *at;
}

void Subdivision::addSide(std::uint32_t edge, std::uint32_t a, std::uint32_t b, std::uint32_t opposite) {
  if (point_of_[a] != edges_[edge].point[0]) std::swap(a, b);
  std::uint32_t& at = sideOf(edge, a, b);
  if (at != kNone) {
    sides_[at].border = false;
    return;
  }
  at = static_cast<std::uint32_t>(sides_.size());
  sides_.push_back({a, b, opposite});
}

std::size_t Subdivision::longest(const Triangle& triangle) const {
  const auto size = [&](std::size_t c) {
    return std::pair(edges_[triangle.edge[c]].square, triangle.edge[c]);
  };
  std::size_t most = 0;
  for (const std::size_t c : {1U, 2U})
    if (size(c) > size(most)) most = c;
  return most;
}

bool Subdivision::asksForLongest(const Triangle& triangle, double stretch) const {
  const double square = edges_[triangle.edge[longest(triangle)]].square;
  return std::any_of(triangle.edge.begin(), triangle.edge.end(), [&](std::uint32_t e) {
    return edges_[e].marked && square >= stretch * stretch * edges_[e].square;
  });
}

void Subdivision::markLongest(double stretch) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const Triangle& t : triangles_) {
      if (!asksForLongest(t, stretch)) continue;
      Edge& most = edges_[t.edge[longest(t)]];
      changed = changed || !most.marked;
      most.marked = true;
    }
  }
}

void Subdivision::cutEdge(std::uint32_t edge, const Middle& middle) {
  const auto [p, q] = edges_[edge].point;
  const auto m = static_cast<std::uint32_t>(points_.size());
  points_.push_back(0.5 * (points_[p] + points_[q]));
  const std::uint32_t first = addEdge(p, m);
  const std::uint32_t second = addEdge(m, q);
  edges_[edge].half = {first, second};
  for (std::uint32_t s = edges_[edge].side; s != kNone; s = sides_[s].next) {
    sides_[s].middle = middle(s);
    point_of_.resize(std::max<std::size_t>(point_of_.size(), sides_[s].middle + 1U));
    point_of_[sides_[s].middle] = m;
  }
}

/// Into two, from the middle of its edge number `at` to the vertex across.
void Subdivision::bisect(const Triangle& t, std::size_t at, std::vector<Triangle>& parts) {
  const std::size_t next = (at + 1) % 3;
  const std::size_t across = (at + 2) % 3;
  const std::uint32_t a = t.vertex[at];
  const std::uint32_t b = t.vertex[next];
  const std::uint32_t c = t.vertex[across];
  const Edge edge = edges_[t.edge[at]];
  const bool forward = point_of_[a] == edge.point[0];
  const std::uint32_t m = sides_[forward ? sideOf(t.edge[at], a, b) : sideOf(t.edge[at], b, a)].middle;
  const std::uint32_t half_a = edge.half[forward ? 0 : 1];
  const std::uint32_t half_b = edge.half[forward ? 1 : 0];
  const std::uint32_t inner = addEdge(point_of_[m], point_of_[c]);
  addSide(half_a, a, m, c);
  addSide(half_b, m, b, c);
  addSide(inner, m, c, a);
  addSide(inner, c, m, b);
  parts.push_back({{a, m, c}, {half_a, inner, t.edge[across]}});
  parts.push_back({{m, b, c}, {half_b, t.edge[next], inner}});
}

void Subdivision::cut(const Middle& middle, double stretch) {
  markLongest(stretch);
  for (std::uint32_t e = 0, count = static_cast<std::uint32_t>(edges_.size()); e < count; ++e)
    if (edges_[e].marked && !edges_[e].isCut()) cutEdge(e, middle);
  std::vector<Triangle> waiting = std::move(triangles_);
  triangles_.clear();
  std::reverse(waiting.begin(), waiting.end());
  while (!waiting.empty()) {
    const Triangle t = waiting.back();
    waiting.pop_back();
    std::size_t at = longest(t);
    for (std::size_t c = 0; c < 3 && !edges_[t.edge[at]].isCut(); ++c) at = c;
    if (edges_[t.edge[at]].isCut())
      bisect(t, at, waiting);
    else
      triangles_.push_back(t);
  }
}

std::vector<std::uint32_t> Subdivision::indices() const {
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * triangles_.size());
  for (const Triangle& t : triangles_) indices.insert(indices.end(), t.vertex.begin(), t.vertex.end());
  return indices;
}

}  // namespace coherency
