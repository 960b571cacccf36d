#pragma once

#include <cstdint>

#include "common/scene/FaceSet.h"

namespace coherency {

/// Linear-light RGB of a colour as screens name it (sRGB, IEC 61966-2-1), 0xRRGGBB.
Coord3 linearColour(std::uint32_t srgb);

/// A surface of that colour.
Material paint(std::uint32_t srgb, double gloss = 0.0);
/// A surface that shines by itself, whatever the light.
Material glow(std::uint32_t srgb);

/// What the operator wears and sits on.
namespace palette {
inline constexpr std::uint32_t kSkin = 0xD8A98A;
inline constexpr std::uint32_t kHair = 0x3B2C24;
inline constexpr std::uint32_t kShirt = 0x5E86AD;
inline constexpr std::uint32_t kShirtTrim = 0x4C7197;
inline constexpr std::uint32_t kTrousers = 0x4A5263;
inline constexpr std::uint32_t kBelt = 0x2E2722;
inline constexpr std::uint32_t kShoe = 0x6B4A34;
inline constexpr std::uint32_t kSole = 0xD9D3C6;
inline constexpr std::uint32_t kSeat = 0x3C4A50;
inline constexpr std::uint32_t kSeatFrame = 0x2B3135;
inline constexpr std::uint32_t kMetal = 0xA3ABB0;
inline constexpr std::uint32_t kWheel = 0x1F2224;
inline constexpr std::uint32_t kHeadset = 0x3A4147;
inline constexpr std::uint32_t kLink = 0xBFC4C6;
inline constexpr std::uint32_t kAccent = 0xC9743A;
}  // namespace palette

}  // namespace coherency
