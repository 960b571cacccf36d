#pragma once

#include <cstdint>
#include <vector>

#include "common/math/Coord3.h"

namespace coherency {

/// Surface of a shape. Colours are linear-light RGB in 0..1.
struct Material {
  Coord3 colour{0.8, 0.8, 0.8};
  double gloss = 0.0;     ///< 0 matt .. 1 polished
  double emission = 0.0;  ///< share of `colour` that shines by itself, 0..1
  bool operator==(const Material&) const = default;
};

/// A coarser form of a curved surface (level of detail), over the vertices of the finest: wherever it is
/// drawn instead, light and memory stay what they were.
struct DetailLevel {
  std::vector<std::vector<std::uint32_t>> faces;  ///< as FaceSet::faces
  /// How far it lies, at most, from the finest surface and from the exact curve that both stand for, m.
  double error = 0.0;
  bool operator==(const DetailLevel&) const = default;
};

/// Plane, convex polygons over shared vertices, in the frame of the object that owns them. Seen from outside
/// the vertices of a face run counter-clockwise.
struct FaceSet {
  std::vector<Coord3> vertices;
  std::vector<std::vector<std::uint32_t>> faces;
  Material material;
  bool smooth = false;  ///< shade across edges (curved surfaces) instead of face by face
  /// Where `smooth`: the edge between two faces stays sharp when they meet at more than this angle, radians.
  double crease_angle = 0.7;
  std::vector<DetailLevel> coarser = {};  ///< the coarsest last: errors rise; none where nothing is curved
};

}  // namespace coherency
