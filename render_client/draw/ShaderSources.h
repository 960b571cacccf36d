#pragma once

#include <cstddef>
#include <string>

namespace coherency {

// GLSL 4.50. What they read is laid out as ViewPass.cpp, ShadowMap.cpp and TextOverlay.cpp write it.

inline constexpr std::size_t kMaxLights = 8;

/// Lighting by the first `lights` (at most kMaxLights) lights, the first of them with shadows where asked
/// for.
std::string sceneVertexShader(std::size_t lights, bool shadows);
std::string sceneFragmentShader(std::size_t lights, bool shadows);
extern const char* const kShadowVertexShader;
extern const char* const kShadowFragmentShader;
extern const char* const kTextVertexShader;
extern const char* const kTextFragmentShader;

}  // namespace coherency
