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

  Coord3& operator+=(const Coord3& b);
  Coord3& operator-=(const Coord3& b);
  Coord3& operator*=(double s);
  /// Throws std::domain_error when `s` is zero.
  Coord3& operator/=(double s);
  bool operator==(const Coord3&) const = default;
};

Coord3 operator+(Coord3 a, const Coord3& b);
Coord3 operator-(Coord3 a, const Coord3& b);
Coord3 operator-(const Coord3& a);
Coord3 operator*(Coord3 a, double s);
Coord3 operator*(double s, Coord3 a);
Coord3 operator/(Coord3 a, double s);

/// Inner product.
double dot(const Coord3& a, const Coord3& b);
/// Right-handed cross product.
Coord3 cross(const Coord3& a, const Coord3& b);
/// Euclidean length; does not overflow or underflow where the result is representable.
double norm(const Coord3& a);
/// Unit vector along `a`; throws std::domain_error when `a` is zero or not finite.
Coord3 normalized(const Coord3& a);
bool isFinite(const Coord3& a);

}  // namespace coherency
