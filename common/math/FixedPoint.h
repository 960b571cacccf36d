#pragma once

#include <cstdint>

namespace coherency {

/// The integer units of everything that is replicated (design: integers as encoders and converters are).
/// A length is int32 in micrometres (+-2147 m) or int64 in nanometres, an angle int32 in 2^-32 turns, which
/// wraps exactly, a ratio int32 in 2^-30 (-2..2).
inline constexpr double kMicrometre = 1e-6;
inline constexpr double kNanometre = 1e-9;
inline constexpr double kTurn = 6.283185307179586476925286766559;
inline constexpr double kAngleUnit = kTurn / 4294967296.0;
inline constexpr double kRatioUnit = 1.0 / 1073741824.0;

/// Nearest unit, halves away from zero. Out-of-range or non-finite input throws std::range_error.
std::int32_t micrometresFromMetres(double metres);
std::int64_t nanometresFromMetres(double metres);
std::int32_t unitsFromRatio(double ratio);
/// Any finite angle; whole turns drop out exactly. Non-finite input throws std::range_error.
std::int32_t unitsFromRadians(double radians);

constexpr double metresFromMicrometres(std::int32_t um) {
  return um * kMicrometre;
}
constexpr double metresFromNanometres(std::int64_t nm) {
  return static_cast<double>(nm) * kNanometre;
}
constexpr double ratioFromUnits(std::int32_t units) {
  return units * kRatioUnit;
}
/// -pi <= result < pi.
constexpr double radiansFromUnits(std::int32_t units) {
  return units * kAngleUnit;
}

}  // namespace coherency
