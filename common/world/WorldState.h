#pragma once

#include <array>
#include <cstdint>

#include <boost/container/static_vector.hpp>

#include "common/math/Rotation.h"
#include "common/motion/MotionSample.h"
#include "common/world/BasePose.h"

namespace coherency {

/// Whom the operator is: the virtual human on the master system, or the slave robot (paper, section IV.B).
enum class Mode : std::uint8_t { Operator, Robot };

/// Something that drives on the floor: the master system with the operator on it, or the slave robot.
struct Vehicle {
  BasePose base;
  /// Speed in the base's own axes and about +y, per second.
  std::int32_t velocity_right_um = 0;
  std::int32_t velocity_ahead_um = 0;
  std::int32_t turn_rate_units = 0;  ///< 2^-32 turns a second
  bool operator==(const Vehicle&) const = default;
};

enum class Holder : std::uint8_t { Nobody, OperatorHand, RobotHand };

/// A cube that can be carried. What a hand holds has its pose in that hand's frame, so that it is drawn from
/// the frame the hand is drawn from and never lags it.
struct Movable {
  Holder holder = Holder::Nobody;
  std::int64_t x_nm = 0;  ///< of its centre, in the world or in the holding hand's frame (ArmKinematics.h)
  std::int64_t y_nm = 0;
  std::int64_t z_nm = 0;
  std::array<std::int32_t, 4> attitude{0, 0, 0, 1 << 30};  ///< quaternion x, y, z, w in 2^-30; w >= 0
  std::int32_t fall_um = 0;                                ///< speed downwards, um/s
  bool resting = true;                                     ///< stands on something and will stay
  std::uint32_t unrest_us = 0;  ///< how long it has sought its rest in touch with things since it was let go
  bool operator==(const Movable&) const = default;
};
Quaternion attitude(const Movable& movable);
void setAttitude(Movable& movable, const Quaternion& q);
/// T_world_movable or T_hand_movable.
TransformMatrix transform(const Movable& movable);

/// The building task (paper, section V): three blocks one upon the other, none in a hand.
struct TaskClock {
  std::uint64_t started_tick = 0;  ///< of the first motion of the joystick; 0: not yet
  std::uint64_t done_tick = 0;     ///< when a tower stood last; 0: never yet
  std::uint32_t towers = 0;        ///< how many have been built
  bool standing = false;           ///< one stands now
  bool operator==(const TaskClock&) const = default;
};

inline constexpr std::int32_t kFastestUm = 100'000'000;      ///< a vehicle's speed, um/s, whatever its limits
inline constexpr std::int32_t kFastestTurn = 2'000'000'000;  ///< and its turn rate
inline constexpr std::int32_t kFastestFallUm = 20'000'000;   ///< of a movable, um/s
inline constexpr std::uint32_t kPatienceUs = 2'000'000;      ///< the most that `unrest_us` counts
inline constexpr std::size_t kMaxMovables = 8;
inline constexpr std::size_t kMaxDoors = 16;
inline constexpr std::int32_t kDoorOpen = 1 << 30;
inline constexpr std::int32_t kDoorPassable = kDoorOpen / 10 * 9;  ///< from here on nobody is stopped

/// What the session shares beside the sample. Plain data and integers; the server steps it, clients receive
/// it.
struct WorldState {
  std::uint64_t tick = 0;  ///< sampling periods since the session began
  Mode mode = Mode::Operator;
  Vehicle master;
  Vehicle robot;
  std::uint8_t closed_hands = 0;  ///< bit 0 the operator's, bit 1 the robot's
  boost::container::static_vector<Movable, kMaxMovables> movables;
  boost::container::static_vector<std::int32_t, kMaxDoors> doors;  ///< 0 closed .. kDoorOpen
  TaskClock task;
  bool operator==(const WorldState&) const = default;

  /// What the joystick drives.
  Vehicle& driven() { return mode == Mode::Robot ? robot : master; }
  const Vehicle& driven() const { return mode == Mode::Robot ? robot : master; }
};

/// Whether a state can be at all: places within the world, speeds and waits that the rules can lead to,
/// attitudes that are rotations, doors between closed and open, modes and holders there are. What comes from
/// wire or file is asked this; whether it is one of a certain world's, World::fits().
bool isValid(const WorldState& state);

/// FNV-1a, 64 bit, over the little-endian bytes of all fields of both, in forEachField()'s order and then the
/// sample's of declaration: what replicas prove their equality by.
std::uint64_t stateHash(const WorldState& state, const MotionSample& sample);

}  // namespace coherency
