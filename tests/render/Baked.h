#pragma once

#include <algorithm>
#include <cmath>

#include "common/scene/Primitives.h"
#include "render_client/compile/Bake.h"

// Scenes whose baked light is looked at.

namespace coherency {

inline constexpr double kQuarter = 1.57079632679489662;

inline Illumination lampOnly(const Coord3& position, double intensity, double reach = 1000.0) {
  return {{{position, {1.0, 1.0, 1.0}, intensity, reach}}, {{}, {}}};
}
inline Illumination ambientOnly(const Coord3& sky, const Coord3& ground) {
  return {{}, {sky, ground}};
}

/// Fixed objects with their light.
struct Baked {
  void add(const VRObject& object) { mesh.add(object, object.globalTransform()); }
  void bakeWith(const Illumination& illumination, int rays = 256) {
    bake = coherency::bake(mesh, illumination, {.rays = rays});
  }

  Coord3 position(std::size_t v) const {
    return mesh.objects[mesh.vertices[v].object].origin + Coord3(glm::dvec3(mesh.vertices[v].position));
  }
  Coord3 normal(std::size_t v) const { return Coord3(glm::dvec3(mesh.vertices[v].normal)); }
  double light(std::size_t v) const { return bake.light[v].light.g; }

  /// Calls visit(position, light) for the vertices of one object that face `towards`.
  template <class Visit>
  void forEach(std::uint32_t object, const Coord3& towards, const Visit& visit) const {
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      if (mesh.vertices[v].object == object && dot(normal(v), towards) > 0.99) visit(position(v), light(v));
  }

  FixedMesh mesh;
  Bake bake;
};

inline constexpr Coord3 kUp{0.0, 1.0, 0.0};
/// Share by which light may be off: on a border it is that of a place 2 cm inside.
inline constexpr double kOff = 0.025;

inline Rectangle& layDown(Rectangle& face, double y = 0.0) {
  face.setOrientation(TransformMatrix::rotationX(-kQuarter));
  face.setPosition(0.0, y, 0.0);
  return face;
}

inline void paint(Polyhedron& object, double grey, double emission = 0.0) {
  object.setMaterial({{grey, grey, grey}, 0.0, emission});
}
inline void paint(Polygon& object, double grey) {
  object.setMaterial({{grey, grey, grey}, 0.0, 0.0});
}

inline double fromLamp(const Coord3& lamp, double intensity, const Coord3& at, const Coord3& normal) {
  const Coord3 to = lamp - at;
  return intensity * std::max(dot(to, normal), 0.0) / std::pow(norm(to), 3.0);
}

}  // namespace coherency
