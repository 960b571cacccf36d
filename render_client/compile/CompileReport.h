#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace coherency {

/// What became of a tree when it was compiled.
struct CompileReport {
  struct Objects {
    std::size_t count = 0;
    std::size_t polygons = 0;
    void add(std::size_t more) { ++count, polygons += more; }
  };
  struct Surfaces {
    std::size_t blocks = 0;     ///< of what moves: wholes, which move as one
    std::size_t triangles = 0;  ///< as they are drawn in full detail
    std::size_t vertices = 0;
  };

  Objects fixed;                     ///< show faces and stand where they were compiled
  std::size_t declared_fixed = 0;    ///< of them, those that may not be moved; the others' moves are noticed
  Objects declared_moving;           ///< and what is part of them
  Objects found_to_move;             ///< were compiled as fixed before, but moved
  std::vector<std::string> found;    ///< their paths; what is part of them has none here
  std::size_t without_faces = 0;     ///< only group others
  Objects without_area;              ///< their faces are points and lines
  Objects flat;                      ///< their transform squashes them
  std::size_t triangles_before = 0;  ///< of what is fixed, before it was cut for its light
  std::size_t triangles_cut = 0;     ///< and after
  Surfaces lit;                      ///< fixed, light at the vertices
  Surfaces mapped;                   ///< fixed, light in the lightmap; `triangles_before` of these
  Surfaces moving;
  std::size_t triangles_coarser = 0;  ///< of all coarser levels, over the same vertices
  std::size_t charts = 0;             ///< flat surfaces with a rectangle in the lightmap
  int lightmap_width = 0;             ///< texels; 0: there is none
  int lightmap_height = 0;
  std::size_t bytes = 0;  ///< vertices, indices and lightmap, on the GPU
  std::size_t enclosures = 0;
  std::size_t lamps = 0;
  double largest_radius = 0.0;  ///< of the spheres about blocks, m
  double tolerance = 0.0;       ///< BakeSettings

  /// That show faces.
  std::size_t objects() const { return fixed.count + declared_moving.count + found_to_move.count; }
  /// How far off the corner of a fixed face is drawn, at most, when it is `distance` m from the first eye and
  /// the object is not sheared, m. A float is off by 2^-24 of its value: the corner's in its object's axes,
  /// in the world's, and in its block (each at most as far from the origin as the largest block's sphere),
  /// that of the block's origin from the eye, and their sum.
  double positionError(double distance) const;
};

/// In words, a line for each thing there is or was left out.
std::string describe(const CompileReport& report);

}  // namespace coherency
