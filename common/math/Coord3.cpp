#include "common/math/Coord3.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace coherency {

Coord3& Coord3::operator/=(double s) {
  if (s == 0.0) throw std::domain_error("Coord3: division by zero");
  x /= s;
  y /= s;
  z /= s;
  return *this;
}

Coord3 operator/(Coord3 a, double s) {
  return a /= s;
}

double norm(const Coord3& a) {
  // Not std::hypot, whose last bit is the C library's. Squares of lengths beyond these would overflow or lose
  // bits.
  constexpr double kLarge = 0x1p+500;
  constexpr double kSmall = 0x1p-450;
  const double largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  const double scale = largest > kLarge ? 0x1p-600 : largest < kSmall ? 0x1p+600 : 1.0;
  const Coord3 s{a.x * scale, a.y * scale, a.z * scale};
  return std::sqrt(s.x * s.x + s.y * s.y + s.z * s.z) / scale;
}

Coord3 normalized(const Coord3& a) {
  const double largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  if (!isFinite(a) || largest == 0.0)
    throw std::domain_error("normalized: a vector that is zero or not finite has no direction");
  const Coord3 scaled = a / largest;  // the length of `a` itself might overflow or lose digits
  return scaled / norm(scaled);
}

bool isFinite(const Coord3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace coherency
