#include "render_client/compile/Refine.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

namespace coherency {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

class Refiner {
 public:
  Refiner(Mesh& mesh, double longest_edge) : mesh_(mesh), longest_square_(longest_edge * longest_edge) {}

  void run() {
    std::vector<Triangle> waiting;
    for (std::size_t i = 0; i + 2 < mesh_.indices.size(); i += 3)
      waiting.push_back({mesh_.indices[i], mesh_.indices[i + 1], mesh_.indices[i + 2]});
    mesh_.indices.clear();
    while (!waiting.empty()) {
      Triangle t = waiting.back();
      waiting.pop_back();
      if (!turnLongestFirst(t)) {
        mesh_.indices.insert(mesh_.indices.end(), t.begin(), t.end());
        continue;
      }
      const std::uint32_t middle = middleOf(t[0], t[1]);
      waiting.push_back({t[0], middle, t[2]});
      waiting.push_back({middle, t[1], t[2]});
    }
  }

 private:
  double square(std::uint32_t a, std::uint32_t b) const {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
      const double d = static_cast<double>(mesh_.vertices[a].position[i]) -
                       static_cast<double>(mesh_.vertices[b].position[i]);
      sum += d * d;
    }
    return sum;
  }

  /// Brings the longest edge between the first two corners; false if it is short enough.
  bool turnLongestFirst(Triangle& t) const {
    const std::array<double, 3> edges{square(t[0], t[1]), square(t[1], t[2]), square(t[2], t[0])};
    const auto longest = std::max_element(edges.begin(), edges.end());
    std::rotate(t.begin(), t.begin() + (longest - edges.begin()), t.end());
    return *longest > longest_square_;
  }

  std::uint32_t middleOf(std::uint32_t a, std::uint32_t b) {
    const auto [found, fresh] =
        middles_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (!fresh) return found->second;
    MeshVertex v = mesh_.vertices[a];
    float length = 0.0F;
    for (int i = 0; i < 3; ++i) {
      v.position[i] = 0.5F * (v.position[i] + mesh_.vertices[b].position[i]);
      v.normal[i] += mesh_.vertices[b].normal[i];
      length += v.normal[i] * v.normal[i];
    }
    for (float& component : v.normal) component /= std::max(std::sqrt(length), 1e-20F);
    mesh_.vertices.push_back(v);
    return found->second;
  }

  Mesh& mesh_;
  double longest_square_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

}  // namespace

void refine(Mesh& mesh, double longest_edge) {
  assert(longest_edge > 0.0);
  Refiner(mesh, longest_edge).run();
}

}  // namespace coherency
