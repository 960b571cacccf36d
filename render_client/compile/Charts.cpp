#include "render_client/compile/Charts.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace coherency {
namespace {

/// Sets of vertices that triangles connect (Galler & Fischer 1964, paths halved).
class Connected {
 public:
  explicit Connected(const FixedMesh& mesh) : above_(mesh.vertices.size()) {
    std::iota(above_.begin(), above_.end(), 0U);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
      for (const std::size_t c : {i + 1, i + 2}) above_[setOf(mesh.indices[c])] = setOf(mesh.indices[i]);
  }
  std::uint32_t setOf(std::uint32_t vertex) {
    while (above_[vertex] != vertex) vertex = above_[vertex] = above_[above_[vertex]];
    return vertex;
  }

 private:
  std::vector<std::uint32_t> above_;
};

using Triangles = std::vector<std::uint32_t>;
using Span = std::pair<std::size_t, std::size_t>;  ///< of indices: first, and one past the last

Span objectFrom(const FixedMesh& mesh, const Triangles& indices, std::size_t first) {
  std::size_t end = first;
  while (end < indices.size() && mesh.vertices[indices[end]].object == mesh.vertices[indices[first]].object)
    end += 3;
  return {first, end};
}

std::map<std::uint32_t, Triangles> surfaces(const Triangles& indices, const Span& span,
                                            Connected& connected) {
  std::map<std::uint32_t, Triangles> found;
  for (std::size_t i = span.first; i < span.second; ++i)
    found[connected.setOf(indices[i - i % 3])].push_back(indices[i]);
  return found;
}

glm::dvec3 position(const FixedMesh& mesh, std::uint32_t vertex) {
  return glm::dvec3(mesh.vertices[vertex].position);
}

/// Calls edge(from, to) for all sides of all triangles.
template <class Edge>
void forEachEdge(const FixedMesh& mesh, const Triangles& triangles, const Edge& edge) {
  for (std::size_t i = 0; i < triangles.size(); ++i)
    edge(position(mesh, triangles[i]), position(mesh, triangles[i % 3 == 2 ? i - 2 : i + 1]));
}

void layAlong(Chart& chart, const FixedMesh& mesh, const glm::dvec3& u, const glm::dvec3& normal) {
  Chart laid = chart;
  laid.u = u;
  laid.v = glm::cross(normal, u);
  laid.low = glm::dvec2(0.0);
  glm::dvec2 low(std::numeric_limits<double>::max());
  glm::dvec2 high(std::numeric_limits<double>::lowest());
  for (const std::uint32_t vertex : chart.cut) {
    const glm::dvec2 at = laid.place(mesh.vertices[vertex]);
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  laid.low = low;
  laid.size = high - low;
  const bool first = chart.u == glm::dvec3(0.0);
  if (first || laid.size.x * laid.size.y < chart.size.x * chart.size.y) chart = std::move(laid);
}

Chart chartOf(const FixedMesh& mesh, Triangles cut, const Triangles& uncut) {
  constexpr std::size_t kTried = 24;  // sides: of a surface of many, some lie well enough
  Chart chart;
  chart.cut = std::move(cut);
  const glm::dvec3 normal(mesh.vertices[chart.cut.front()].normal);
  const Triangles some(uncut.begin(),
                       uncut.begin() + static_cast<std::ptrdiff_t>(std::min(uncut.size(), kTried)));
  forEachEdge(mesh, some, [&](const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 along = (to - from) - glm::dot(to - from, normal) * normal;
    if (glm::length(along) > 1e-6) layAlong(chart, mesh, glm::normalize(along), normal);
  });
  chart.shortest = std::numeric_limits<double>::max();
  forEachEdge(mesh, chart.cut, [&](const glm::dvec3& from, const glm::dvec3& to) {
    chart.shortest = std::min(chart.shortest, glm::distance(from, to));
  });
  return chart;
}

}  // namespace

glm::dvec2 Chart::place(const FixedVertex& vertex) const {
  const glm::dvec3 at(vertex.position);
  return glm::dvec2(glm::dot(at, u), glm::dot(at, v)) - low;
}

Charts findCharts(const FixedMesh& mesh, const std::vector<std::uint32_t>& uncut) {
  Charts result;
  if (mesh.indices.size() == uncut.size()) return result;
  result.of_vertex.resize(mesh.vertices.size(), Charts::kNone);
  Connected connected(mesh);
  Span now{0, 0};
  for (Span before{0, 0}; before.second < uncut.size();) {
    before = objectFrom(mesh, uncut, before.second);
    now = objectFrom(mesh, mesh.indices, now.second);
    assert(mesh.vertices[uncut[before.first]].object == mesh.vertices[mesh.indices[now.first]].object);
    const bool is_cut = now.second - now.first > before.second - before.first;
    if (!is_cut || mesh.objectOf(uncut[before.first]).object->faces()->smooth) continue;
    const std::map<std::uint32_t, Triangles> were = surfaces(uncut, before, connected);
    for (auto& [set, cut] : surfaces(mesh.indices, now, connected)) {
      const Triangles& was = were.at(set);
      if (cut.size() == was.size()) continue;
      for (const std::uint32_t vertex : cut)
        result.of_vertex[vertex] = static_cast<std::uint32_t>(result.charts.size());
      result.charts.push_back(chartOf(mesh, std::move(cut), was));
    }
  }
  return result;
}

}  // namespace coherency
