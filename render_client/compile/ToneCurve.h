#pragma once

#include <algorithm>
#include <cmath>

// How light becomes a picture. The shaders have the same.

namespace coherency {

/// Straight up to a half, then a shoulder that reaches 1 at infinity: nothing clips. Linear light in and out.
inline float tone(float light) {
  return light < 0.5F ? light : 1.0F - 0.25F / light;
}

/// A display's value of linear light in 0..1 (sRGB, IEC 61966-2-1).
inline float encoded(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

/// The same as the shaders have it, to 0.09 % of white: beyond sRGB's straight part a polynomial of the root.
inline float encodedByShaders(float linear) {
  const float r = std::sqrt(linear);
  const float curve =
      (((-0.311395113F * r + 0.846885902F) * r - 0.947945999F) * r + 1.448778461F) * r - 0.037078028F;
  return std::max(curve, std::min(12.92F * linear, 0.04045F));
}

}  // namespace coherency
