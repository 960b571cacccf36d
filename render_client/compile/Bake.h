#pragma once

#include <memory>
#include <vector>

#include "render_client/compile/BakeSettings.h"
#include "render_client/compile/FixedMesh.h"
#include "render_client/compile/LightBaker.h"

namespace coherency {

/// What was baked, and who can answer more questions about the light among the same things.
struct Bake {
  std::vector<SurfaceLight> light;  ///< of the mesh's vertices
  Coord3 origin;                    ///< of the baker's coordinates, in the world
  std::unique_ptr<LightBaker> baker;
};

/// Computes the light at all vertices of what never moves, and bisects edges until the light between vertices
/// is right too when it is interpolated. Runs on several threads; the outcome is the same on every machine
/// that has the same floats.
Bake bake(FixedMesh& mesh, const Illumination& illumination, const BakeSettings& settings);

}  // namespace coherency
