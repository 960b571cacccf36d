#pragma once

#include <cstdint>

#include "common/body/Palette.h"
#include "common/scene/Light.h"
#include "common/scene/Senses.h"

// What the building is made of: its colours, as screens name them (0xRRGGBB), how its materials push back,
// and the light that comes from everywhere.

namespace coherency::finish {

inline constexpr std::uint32_t kWarmWhite = 0xEBE5DA;
inline constexpr std::uint32_t kCeiling = 0xF4F1EA;
inline constexpr std::uint32_t kSage = 0xB4BFB2;
inline constexpr std::uint32_t kBlueGrey = 0x5F7F8A;
inline constexpr std::uint32_t kOak = 0xB98D5E;
inline constexpr std::uint32_t kPaleOak = 0xD2B084;
inline constexpr std::uint32_t kWalnut = 0x8F6A44;
inline constexpr std::uint32_t kLaminate = 0xE8E4DB;
inline constexpr std::uint32_t kSteel = 0x5B6166;
inline constexpr std::uint32_t kStainless = 0xB4BABD;
inline constexpr std::uint32_t kBlack = 0x26292C;
inline constexpr std::uint32_t kPaper = 0xF5F2EA;
inline constexpr std::uint32_t kRed = 0xB83A2E;
inline constexpr std::uint32_t kTeal = 0x3B6470;
inline constexpr std::uint32_t kRust = 0xC9743A;

/// The same in every room, so that it does not matter which of them a scene names first.
inline Ambient ambient() {
  return {{0.36, 0.37, 0.39}, {0.25, 0.235, 0.215}};
}

/// A surface in daylight: mostly its own light, so that a room's lamps change little.
inline Material daylit(std::uint32_t srgb) {
  Material material = paint(srgb);
  material.emission = 0.75;
  return material;
}

// Stiffness of hard materials: that of Hertz's contact with a rigid ball of 8 mm radius, a fingertip's,
// pressed on with 5 N, 2 E* a with a^3 = 3 F R / 4 E*; Young's moduli of 1 GPa (oak across the grain), 2 GPa
// (gypsum plaster), 3 GPa (polymers), 70 GPa (glass), 200 GPa (steel). Soft ones: force over depth of what
// gives way as a whole, a seat cushion under a hand (about 150 N for 40 mm) and a leaf that bends.
inline Surface wood() {
  return {"wood", 6.2e5};
}
inline Surface plaster() {
  return {"plaster", 9.9e5};
}
inline Surface plastic() {
  return {"plastic", 1.3e6};
}
inline Surface glass() {
  return {"glass", 1.1e7};
}
inline Surface steel() {
  return {"steel", 2.1e7};
}
inline Surface cushion() {
  return {"cushion", 3.8e3};
}
inline Surface leaf() {
  return {"leaf", 30.0};
}

}  // namespace coherency::finish
