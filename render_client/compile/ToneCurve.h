#pragma once

#include <algorithm>
#include <cmath>

// How light becomes a picture. The shaders have the same.

namespace coherency {

/// Straight up to a half, then a shoulder that reaches 1 at infinity: nothing clips. Linear light in and out.
inline float tone(float light) {
  const float over = light > 0.5F ? light - 0.5F : 0.0F;
  return (light < 0.5F ? light : 0.5F) + 0.5F * over / (0.5F + over);
}

/// A display's value of linear light in 0..1 (sRGB, IEC 61966-2-1).
inline float encoded(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

/// The same as the shaders have it, to 0.1 % of white: Taylor's square roots (sRGB approximations for HLSL,
/// 2013), and sRGB's straight part where they fall below it.
inline float encodedByShaders(float linear) {
  const float root = std::sqrt(linear);
  const float fourth = std::sqrt(root);
  const float curve =
      0.662002687F * root + 0.684122060F * fourth - 0.323583601F * std::sqrt(fourth) - 0.0225411470F * linear;
  return std::max(curve, std::min(12.92F * linear, 0.04045F));
}

}  // namespace coherency
