#pragma once

#include "common/math/TransformMatrix.h"

namespace coherency {

/// Head attitude: R = Ry(yaw) Rx(pitch) Rz(roll), radians. Positive yaw turns left, positive pitch looks up,
/// positive roll tilts the head's right side up.
struct YawPitchRoll {
  double yaw = 0.0;
  double pitch = 0.0;
  double roll = 0.0;
  bool operator==(const YawPitchRoll&) const = default;
};

TransformMatrix rotation(const YawPitchRoll& angles);
/// Inverse of rotation(): pitch in [-pi/2, pi/2], yaw and roll in [-pi, pi]. Where pitch is +-pi/2 and yaw
/// and roll are not determined, roll is 0. Precondition: the 3x3 part of `r` is a rotation.
YawPitchRoll yawPitchRoll(const TransformMatrix& r);

/// Unit quaternion by name, so that no library's component order is ever assumed.
struct Quaternion {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double w = 1.0;
};

/// Throws std::domain_error when `q` is zero or not finite; otherwise of unit length.
Quaternion normalized(const Quaternion& q);
TransformMatrix rotation(const Quaternion& q);
Quaternion quaternion(const TransformMatrix& r);
/// Shortest-arc spherical interpolation, s in 0..1; q and -q are the same rotation. Well behaved where the
/// two are equal, nearly equal or nearly opposite.
Quaternion slerp(const Quaternion& a, const Quaternion& b, double s);

/// The rotation by the smallest angle that takes direction `from` to direction `to`; opposite directions give
/// a half turn about some axis normal to them. Throws std::domain_error when either is zero.
TransformMatrix rotationBetween(const Coord3& from, const Coord3& to);

}  // namespace coherency
