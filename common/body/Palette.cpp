#include "common/body/Palette.h"

#include <cmath>

namespace coherency {

namespace {

double linear(std::uint32_t byte) {
  const double s = byte / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

}  // namespace

Coord3 linearColour(std::uint32_t srgb) {
  return {linear((srgb >> 16) & 0xFFu), linear((srgb >> 8) & 0xFFu), linear(srgb & 0xFFu)};
}

Material paint(std::uint32_t srgb, double gloss) {
  return {linearColour(srgb), gloss, 0.0};
}

Material glow(std::uint32_t srgb) {
  return {linearColour(srgb), 0.0, 1.0};
}

}  // namespace coherency
