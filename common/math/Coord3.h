#pragma once

#include <glm/vec3.hpp>

namespace coherency {

/// A position, direction or size in three-dimensional space (paper, section III.B).
/// Metres where a length is meant; right-handed, y up, -z ahead.
class Coord3 {
 public:
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  constexpr Coord3() = default;
  constexpr Coord3(double x_, double y_, double z_) : x(x_), y(y_), z(z_) {}
  explicit Coord3(const glm::dvec3& v) : x(v.x), y(v.y), z(v.z) {}
  glm::dvec3 glm() const { return {x, y, z}; }

  Coord3& operator+=(const Coord3& b) { return *this = {x + b.x, y + b.y, z + b.z}; }
  Coord3& operator-=(const Coord3& b) { return *this = {x - b.x, y - b.y, z - b.z}; }
  Coord3& operator*=(double s) { return *this = {x * s, y * s, z * s}; }
  /// Throws std::domain_error when `s` is zero.
  Coord3& operator/=(double s);
  bool operator==(const Coord3&) const = default;
};

inline Coord3 operator+(Coord3 a, const Coord3& b) {
  return a += b;
}
inline Coord3 operator-(Coord3 a, const Coord3& b) {
  return a -= b;
}
inline Coord3 operator-(const Coord3& a) {
  return {-a.x, -a.y, -a.z};
}
inline Coord3 operator*(Coord3 a, double s) {
  return a *= s;
}
inline Coord3 operator*(double s, Coord3 a) {
  return a *= s;
}
Coord3 operator/(Coord3 a, double s);

/// Inner product.
inline double dot(const Coord3& a, const Coord3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Right-handed cross product.
inline Coord3 cross(const Coord3& a, const Coord3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Euclidean length; does not overflow or underflow where the result is representable.
double norm(const Coord3& a);
/// Unit vector along `a`; throws std::domain_error when `a` is zero or not finite.
Coord3 normalized(const Coord3& a);
bool isFinite(const Coord3& a);

}  // namespace coherency
