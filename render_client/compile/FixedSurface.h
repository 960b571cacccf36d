#pragma once

#include <limits>

#include "render_client/compile/FixedMesh.h"
#include "render_client/compile/LightBaker.h"
#include "render_client/compile/Subdivision.h"

namespace coherency {

/// A fixed mesh while it is cut for light: where its vertices and the middles of its sides are, in
/// coordinates near enough to their origin for float. There is one origin for all, in the middle of what
/// keeps light away, so rays are as exact as a float that far from it: 4 um in a building, 1 mm 10 km away,
/// which is a fifth of how far off a surface light is taken. Things further apart than that are not to be in
/// one scene. Light and how triangles are cut for it depend on it in the last bits; where a thing is drawn
/// does not, as vertices are relative to their own object.
class FixedSurface {
 public:
  /// `mesh` must outlive this.
  explicit FixedSurface(FixedMesh& mesh);

  const FixedMesh& mesh() const { return mesh_; }
  const Coord3& origin() const { return origin_; }  ///< in the world
  const Subdivision& subdivision() const { return subdivision_; }

  /// Bisects edges longer than an object's longest until there are none.
  void cutLongEdges();
  void mark(std::size_t edge) { subdivision_.mark(edge); }
  /// Cuts what is marked (Subdivision::cut()), and calls made(side) for each vertex that is added, in the
  /// order of their adding.
  template <class Made>
  void cut(const Made& made, double stretch = 0.0) {
    const auto middle = [&](std::uint32_t side) {
      addMiddle(subdivision_.sides()[side]);
      made(side);
      return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    };
    subdivision_.cut(middle, stretch);
  }
  /// Writes the triangles, as cut so far, to the mesh.
  void writeIndices() { mesh_.indices = subdivision_.indices(); }

  SurfacePoint at(std::uint32_t vertex) const;
  SurfacePoint halfway(const Subdivision::Side& side) const;
  /// All that keeps light away. Precondition: writeIndices().
  std::vector<Occluder> occluders() const;

 private:
  glm::dvec3 fromOrigin(const FixedVertex& vertex) const;
  std::vector<glm::dvec3> positions() const;
  FixedVertex middleOf(const Subdivision::Side& side) const;
  glm::vec3 insideOf(const Subdivision::Side& side) const;
  void addMiddle(const Subdivision::Side& side);
  void findInsides();
  bool markLongEdges();

  FixedMesh& mesh_;
  Coord3 origin_;
  Subdivision subdivision_;
  std::size_t next_ = 0;           ///< edge whose length has not been looked at
  std::vector<glm::vec3> inside_;  ///< by vertex: SurfacePoint::inside
};

}  // namespace coherency
