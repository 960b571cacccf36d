#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

namespace coherency {

/// Triangles that are cut by bisecting marked edges, so that no gap opens: vertices in one place count as one
/// point, whatever their normals, and an edge between two points is cut in all triangles that have it or in
/// none. A triangle that is cut is cut at its longest edge first, which keeps triangles from growing thin
/// (Rivara 1984); edges that must be cut for that are marked too. How thin they may grow is the caller's to
/// say.
class Subdivision {
 public:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  /// An edge as some triangles have it: between these two vertices.
  struct Side {
    std::uint32_t a, b;            ///< vertices at the edge's first and second point
    std::uint32_t opposite;        ///< third vertex of one of the triangles
    bool border = true;            ///< only one triangle has it so
    std::uint32_t middle = kNone;  ///< vertex where it was cut
    std::uint32_t next = kNone;    ///< side of the same edge
  };
  struct Edge {
    std::array<std::uint32_t, 2> point;
    double square;                                    ///< of its length, m^2
    std::uint32_t side = kNone;                       ///< the first
    bool marked = false;                              ///< to be cut, or cut already
    std::array<std::uint32_t, 2> half{kNone, kNone};  ///< its edges since it was cut
    bool isCut() const { return half[0] != kNone; }
  };

  /// Vertices within about `weld` metres of each other are one point.
  Subdivision(const std::vector<glm::dvec3>& vertices, const std::vector<std::uint32_t>& indices,
              double weld);

  /// Edges in the order of their making, those that have been cut too.
  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<Side>& sides() const { return sides_; }
  void mark(std::size_t edge) { edges_[edge].marked = true; }
  /// Cuts what is marked. `middle(side)` makes the vertex halfway along a side and returns its number.
  using Middle = std::function<std::uint32_t(std::uint32_t side)>;
  /// A triangle's longest edge need not be cut where it is less than `stretch` times as long as one that is:
  /// what changes in one direction only is then cut across that only.
  void cut(const Middle& middle, double stretch = 0.0);
  /// Three vertices a triangle, wound as they were.
  std::vector<std::uint32_t> indices() const;

 private:
  struct Triangle {
    std::array<std::uint32_t, 3> vertex;
    std::array<std::uint32_t, 3> edge;  ///< from each vertex to the next
  };

  std::uint32_t addEdge(std::uint32_t p, std::uint32_t q);
  void addSide(std::uint32_t edge, std::uint32_t a, std::uint32_t b, std::uint32_t opposite);
  std::uint32_t& sideOf(std::uint32_t edge, std::uint32_t a, std::uint32_t b);
  std::size_t longest(const Triangle& triangle) const;
  bool asksForLongest(const Triangle& triangle, double stretch) const;
  void markLongest(double stretch);
  void cutEdge(std::uint32_t edge, const Middle& middle);
  void bisect(const Triangle& triangle, std::size_t at, std::vector<Triangle>& parts);

  std::vector<glm::dvec3> points_;
  std::vector<std::uint32_t> point_of_;  ///< by vertex
  std::vector<Edge> edges_;
  std::vector<Side> sides_;
  std::vector<Triangle> triangles_;
};

}  // namespace coherency
