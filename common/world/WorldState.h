#pragma once

#include <cstdint>

#include "common/math/TransformMatrix.h"
#include "common/motion/MotionSample.h"

namespace coherency {

/// Where the operator's base (the body frame on the floor) is: integer, so that it is the same bits in every
/// replica.
struct BasePose {
  std::int64_t x_nm = 0;
  std::int64_t y_nm = 0;
  std::int64_t z_nm = 0;
  std::int32_t heading_units = 0;  ///< 2^-32 turns about +y; 0 faces -z; positive turns left
  bool operator==(const BasePose&) const = default;
};

/// T_world_body.
TransformMatrix transform(const BasePose& base);

/// What the session shares beside the sample. Plain data and integers; the server steps it, clients receive
/// it.
struct WorldState {
  std::uint64_t tick = 0;  ///< sampling periods since the session began
  BasePose base;
  /// Speed in the base's own axes and about +y, per second.
  std::int32_t velocity_right_um = 0;
  std::int32_t velocity_ahead_um = 0;
  std::int32_t turn_rate_units = 0;  ///< 2^-32 turns a second
  bool operator==(const WorldState&) const = default;
};

/// FNV-1a, 64 bit, over the little-endian bytes of all fields of both, in order of declaration: what replicas
/// prove their equality by.
std::uint64_t stateHash(const WorldState& state, const MotionSample& sample);

/// Part of the floor the base may be on, in world coordinates.
struct DriveArea {
  double min_x = -1e6, max_x = 1e6, min_z = -1e6, max_z = 1e6;  ///< m
};

/// Limits of driving by joystick (stick_y ahead, stick_x sideways, stick_twist turns; twist is positive to
/// the left). Left pedal brakes, right pedal raises the speed up to `boost`.
struct DriveLimits {
  double speed = 0.8;              ///< m/s at full stick
  double boost = 2.0;              ///< speed factor at full right pedal
  double turn_rate = 0.8;          ///< rad/s at full twist
  double acceleration = 1.5;       ///< m/s^2
  double turn_acceleration = 3.0;  ///< rad/s^2
  double brake = 6.0;              ///< m/s^2 at full left pedal
};

/// One period of `period_ns` of driving. DOFs that are not valid drive nothing: the stick reads zero and the
/// base comes to rest within its acceleration. Speed across a border of `area` is lost, along it is kept (one
/// slides).
void step(WorldState& state, const MotionSample& sample, std::int64_t period_ns, const DriveLimits& limits,
          const DriveArea& area);

}  // namespace coherency
