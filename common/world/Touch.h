#pragma once

#include <string>
#include <vector>

#include "common/math/Frustum.h"
#include "common/scene/VRObject.h"

namespace coherency {

/// One object that a probe has reached into.
struct Touched {
  std::string object;  ///< its path
  std::string
      material;  ///< of the nearest Surface (common/scene/Senses.h) on or above it; empty: none is said
  double depth_m = 0.0;  ///< how far the probe reaches in
  double force_n = 0.0;  ///< what pushes back: depth times stiffness; 0 where none is said
  Coord3 normal;         ///< of the face, outward, unit, world
};

/// What a ball-shaped probe touches (a fingertip, a palm): every object under `root` with a face nearer to
/// the probe's centre than its radius. The nearest face pushes outward, also where the centre is behind it,
/// up to a radius deep; what reached in deeper is through. Deepest first. Objects in `without`, and all below
/// them, are passed over. World coordinates, metres.
std::vector<Touched> touchedBy(const Sphere& probe, const VRObject& root,
                               const std::vector<const VRObject*>& without);

/// As a sentence: "table top (wood), 3 mm deep, pushes back with 60 N"; "nothing" where there is none.
std::string describe(const std::vector<Touched>& touched);

}  // namespace coherency
