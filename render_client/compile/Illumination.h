#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "common/scene/Light.h"

namespace coherency {

/// The light of a world: its lamps and what comes from everywhere. Lamps do not move.
struct Illumination {
  std::vector<Light> lamps;  ///< positions in the world, m
  Ambient ambient;
};

/// Irradiance of a surface that faces a lamp of intensity 1, by the square of the distance, m^2: inverse
/// square, but no nearer than 0.5 m, as lamps are not points, and fading to nothing at the lamp's reach
/// (Karis, Real Shading in Unreal Engine 4, 2013). The shaders have the same.
inline float falloff(float square, float reach) {
  const float x = square / (reach * reach);
  const float fade = x < 1.0F ? 1.0F - x * x : 0.0F;
  return fade * fade / (square > 0.25F ? square : 0.25F);
}

/// Shadows of what moves fall as from a wide lamp overhead, a little to one side, so that one sees them
/// beside what casts them: towards this from straight below, m for each m of height, in the world's x and z.
inline constexpr glm::vec2 kShadowLean{-0.4F, 0.2F};

/// Share of the ambient light that something just above keeps away. The shaders have the same.
inline constexpr float kAmbientShade = 0.3F;

/// How bright light looks (Rec. 709).
inline float brightness(const glm::vec3& light) {
  return 0.2126F * light.r + 0.7152F * light.g + 0.0722F * light.b;
}

}  // namespace coherency
