#include "common/math/Rotation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace coherency {
namespace {

/// Some unit vector normal to the unit vector `u`.
Coord3 anyPerpendicular(const Coord3& u) {
  const bool x_is_far = std::abs(u.x) < 0.6;
  return normalized(cross(u, x_is_far ? Coord3{1.0, 0.0, 0.0} : Coord3{0.0, 1.0, 0.0}));
}

/// Axis of the rotation from unit vector `u` to unit vector `v`. Where they are nearly parallel or opposite
/// their cross product is mostly rounding; taking its part along `u` away leaves an axis good to the last
/// digits.
Coord3 axisBetween(const Coord3& u, const Coord3& v) {
  const Coord3 c = cross(u, v);
  if (norm(c) > 0.0) {
    Coord3 n = normalized(c);
    n -= dot(n, u) * u;
    if (norm(n) > 0.5) return normalized(n);
  }
  return anyPerpendicular(u);
}

Quaternion operator*(const Quaternion& q, double s) {
  return {q.x * s, q.y * s, q.z * s, q.w * s};
}
Quaternion operator+(const Quaternion& a, const Quaternion& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
double dot(const Quaternion& a, const Quaternion& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
double norm(const Quaternion& q) {
  return std::sqrt(dot(q, q));
}

}  // namespace

TransformMatrix rotation(const YawPitchRoll& angles) {
  return TransformMatrix::rotationY(angles.yaw) * TransformMatrix::rotationX(angles.pitch) *
         TransformMatrix::rotationZ(angles.roll);
}

YawPitchRoll yawPitchRoll(const TransformMatrix& r) {
  constexpr double kLocked = 1e-14;  // cosine of a pitch that leaves yaw and roll undetermined
  YawPitchRoll angles;
  const double cos_pitch = std::hypot(r(0, 2), r(2, 2));
  angles.pitch = std::atan2(-r(1, 2), cos_pitch);
  if (cos_pitch < kLocked) {
    angles.yaw = std::atan2(-r(2, 0), r(0, 0));
    return angles;
  }
  angles.yaw = std::atan2(r(0, 2), r(2, 2));
  // Roll from the matrix with the yaw just found taken out: near +-90 degrees yaw and roll are each
  // uncertain, and only so is their sum right.
  const double c = std::cos(angles.yaw);
  const double s = std::sin(angles.yaw);
  angles.roll = std::atan2(s * r(2, 1) - c * r(0, 1), c * r(0, 0) - s * r(2, 0));
  return angles;
}

Quaternion normalized(const Quaternion& q) {
  const double largest = std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z), std::abs(q.w)});
  const bool finite = std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) && std::isfinite(q.w);
  if (!finite || largest == 0.0)
    throw std::domain_error("normalized: a quaternion that is zero or not finite is no rotation");
  const Quaternion scaled{q.x / largest, q.y / largest, q.z / largest, q.w / largest};
  return scaled * (1.0 / norm(scaled));
}

TransformMatrix rotation(const Quaternion& q) {
  const auto [x, y, z, w] = normalized(q);
  return TransformMatrix::fromAxes(
      {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)},
      {2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)},
      {2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)});
}

/// Shepperd's method (Journal of Guidance and Control 1, 1978): start from the largest of the four
/// components.
Quaternion quaternion(const TransformMatrix& r) {
  const double xx = r(0, 0);
  const double yy = r(1, 1);
  const double zz = r(2, 2);
  const double trace = xx + yy + zz;
  const double largest = std::max({trace, xx, yy, zz});
  Quaternion q;
  if (largest == trace)
    q = {r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1), 1.0 + trace};
  else if (largest == xx)
    q = {1.0 + xx - yy - zz, r(0, 1) + r(1, 0), r(0, 2) + r(2, 0), r(2, 1) - r(1, 2)};
  else if (largest == yy)
    q = {r(0, 1) + r(1, 0), 1.0 + yy - xx - zz, r(1, 2) + r(2, 1), r(0, 2) - r(2, 0)};
  else
    q = {r(0, 2) + r(2, 0), r(1, 2) + r(2, 1), 1.0 + zz - xx - yy, r(1, 0) - r(0, 1)};
  return normalized(q);
}

Quaternion slerp(const Quaternion& a, const Quaternion& b, double s) {
  const Quaternion near_b = dot(a, b) < 0.0 ? b * -1.0 : b;
  // Kahan's angle between vectors: right to the last digits from 0 up; after the flip it is at most pi / 2.
  const double angle = 2.0 * std::atan2(norm(a + near_b * -1.0), norm(a + near_b));
  const double sine = std::sin(angle);
  if (sine < 1e-12) return normalized(s < 0.5 ? a : near_b);
  return normalized(a * (std::sin((1.0 - s) * angle) / sine) + near_b * (std::sin(s * angle) / sine));
}

TransformMatrix rotationBetween(const Coord3& from, const Coord3& to) {
  const Coord3 u = normalized(from);
  const Coord3 v = normalized(to);
  const Coord3 n = axisBetween(u, v);
  // Rodrigues' formula, with sine and cosine from the vectors themselves: no angle is needed.
  const double sine = norm(cross(u, v));
  const double cosine = dot(u, v);
  const double one_less_cosine = cosine > 0.0 ? sine * sine / (1.0 + cosine) : 1.0 - cosine;
  const auto column = [&](const Coord3& e) {
    return e + sine * cross(n, e) + one_less_cosine * cross(n, cross(n, e));
  };
  return TransformMatrix::fromAxes(column({1.0, 0.0, 0.0}), column({0.0, 1.0, 0.0}), column({0.0, 0.0, 1.0}));
}

}  // namespace coherency
