#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace coherency {

/// The master's 19 degrees of freedom in wire order (paper, section IV.A.1; design, "The 19 DOFs").
enum class Dof : std::uint8_t {
  HeadX,
  HeadY,
  HeadZ,
  HeadYaw,
  HeadPitch,
  HeadRoll,
  ShoulderFlexion,
  ShoulderAbduction,
  ShoulderRotation,
  ElbowFlexion,
  ForearmRotation,
  WristFlexion,
  WristDeviation,
  Grip,
  StickX,
  StickY,
  StickTwist,
  PedalLeft,
  PedalRight,
};
inline constexpr std::size_t kDofCount = 19;
inline constexpr std::size_t kArmJointCount = 7;

constexpr std::size_t index(Dof dof) {
  return static_cast<std::size_t>(dof);
}
constexpr Dof dofAt(std::size_t i) {
  return static_cast<Dof>(i);
}

/// One bit a DOF, bit i for dofAt(i).
using DofMask = std::uint32_t;
inline constexpr DofMask kAllDofs = (DofMask{1} << kDofCount) - 1;
constexpr DofMask mask(Dof dof) {
  return DofMask{1} << index(dof);
}

enum class DofKind : std::uint8_t { Length, Angle, Ratio };

/// What is known of a DOF. Head x, y, z: position of the head's centre in the body frame (origin on the floor
/// under the seat, y up, -z ahead). Yaw, pitch, roll: see YawPitchRoll. Arm: see ArmKinematics. `min` and
/// `max` are what a master may report, in SI; anything outside is a fault, not a motion.
struct DofInfo {
  std::string_view name;
  DofKind kind;
  double min;
  double max;
  std::string_view meaning;
};

/// The one table; configuration, wire, command line, docs and plots read it.
const std::array<DofInfo, kDofCount>& dofTable();
inline const DofInfo& info(Dof dof) {
  return dofTable()[index(dof)];
}
std::optional<Dof> dofByName(std::string_view name);

std::string_view unitName(DofKind kind);  ///< "m", "rad" or "" for a ratio
double resolution(DofKind kind);          ///< one integer unit in SI

/// SI value <-> the integer unit of its kind (FixedPoint.h). Precondition of the first: finite and in range.
std::int32_t unitsFromSi(DofKind kind, double si);
double siFromUnits(DofKind kind, std::int32_t units);

}  // namespace coherency
