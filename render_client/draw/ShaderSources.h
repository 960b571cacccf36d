#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace coherency {

// GLSL 4.50. What they read is laid out as ViewUniforms.cpp, BlockPass.h, MovingPass.h, OverheadShadow.cpp
// and TextOverlay.cpp write it, and what IdPicture.h reads as they write it.

/// m, of a tile of the shadow map, on the floor.
inline constexpr double kShadowTileWidth = 3.2;

/// A map of shadows (OverheadShadow).
struct ShadowMapSize {
  int resolution = 0;  ///< texels a side of a tile; 0: no shadows
  int tiles = 1;       ///< side by side; 1 or 2
};

/// Where the light of a surface comes from. Lamps: it moves.
enum class LightSource : std::uint8_t { Vertices, Lightmap, Lamps };

/// What a shader is made for, so that it has no loops or branches.
struct ShaderVariant {
  LightSource light = LightSource::Vertices;
  std::size_t lamps = 0;  ///< of the chosen ones, for what moves
  ShadowMapSize shadows = {};
  bool ids = false;  ///< what is drawn, in place of how it looks (IdPicture)
};

std::string fixedVertexShader(const ShaderVariant& variant);
std::string movingVertexShader(const ShaderVariant& variant);
/// Goes with both.
std::string fragmentShader(const ShaderVariant& variant);

extern const char* const kShadowVertexShader;
extern const char* const kShadowFragmentShader;
extern const char* const kTextVertexShader;
extern const char* const kTextFragmentShader;

}  // namespace coherency
