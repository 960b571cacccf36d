#pragma once

#include <cmath>
#include <cstdint>

#include <rapidcheck.h>

#include "common/math/Rotation.h"

// Arbitrary values for properties. Each call draws, so these are for the inside of a RapidCheck property.

namespace coherency::random {

/// Uniform in [low, high], both ends possible; shrinks towards `low`.
inline double real(double low, double high) {
  constexpr std::int64_t kSteps = std::int64_t{1} << 40;
  const auto step = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(0, kSteps + 1));
  return low + (high - low) * (static_cast<double>(step) / static_cast<double>(kSteps));
}

inline double angle() {
  return real(-3.14159265358979, 3.14159265358979);
}

/// Magnitudes from 10^low to 10^high, either sign.
inline double magnitude(double low, double high) {
  const double value = std::pow(10.0, real(low, high));
  return *rc::gen::arbitrary<bool>() ? value : -value;
}

inline Coord3 vector(double extent) {
  return {real(-extent, extent), real(-extent, extent), real(-extent, extent)};
}

inline Coord3 direction() {
  const double up = real(-1.0, 1.0);
  const double around = angle();
  const double flat = std::sqrt(1.0 - up * up);
  return normalized(Coord3{flat * std::cos(around), up, flat * std::sin(around)});
}

inline TransformMatrix rotationMatrix() {
  return TransformMatrix::rotation(direction(), angle());
}

inline TransformMatrix rigid(double extent) {
  TransformMatrix t = rotationMatrix();
  t.setOrigin(vector(extent));
  return t;
}

/// Rotation, scale, mirroring, shear and translation, conditioned no worse than about 10^4.
inline TransformMatrix affine(double extent) {
  const Coord3 scale{magnitude(-2, 2), magnitude(-2, 2), magnitude(-2, 2)};
  TransformMatrix t = rotationMatrix() * TransformMatrix::scaling(scale) * rotationMatrix();
  t.setOrigin(vector(extent));
  return t;
}

}  // namespace coherency::random

namespace coherency {

/// Largest difference between corresponding elements.
inline double largestDifference(const TransformMatrix& a, const TransformMatrix& b) {
  double largest = 0.0;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      const double difference = std::abs(a(row, column) - b(row, column));
      if (!(difference <= largest)) largest = difference;  // a NaN comes through
    }
  return largest;
}

}  // namespace coherency
