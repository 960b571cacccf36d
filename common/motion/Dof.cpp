#include "common/motion/Dof.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr double kPi = std::numbers::pi;

constexpr std::array<DofInfo, kDofCount> kTable = {{
    {"head_x", DofKind::Length, -10.0, 10.0, "head centre to the right of the seat"},
    {"head_y", DofKind::Length, -4.0, 4.0, "head centre above the floor"},
    {"head_z", DofKind::Length, -10.0, 10.0, "head centre behind the seat"},
    {"head_yaw", DofKind::Angle, -kPi, kPi, "head turns left"},
    {"head_pitch", DofKind::Angle, -kPi / 2, kPi / 2, "head looks up"},
    {"head_roll", DofKind::Angle, -kPi, kPi, "head's right side tilts up"},
    {"shoulder_flexion", DofKind::Angle, -1.6, 3.2, "upper arm is raised forward"},
    {"shoulder_abduction", DofKind::Angle, -1.5, 1.5, "upper arm is moved away from the body"},
    {"shoulder_rotation", DofKind::Angle, -2.3, 2.3, "upper arm turns inward"},
    {"elbow_flexion", DofKind::Angle, -0.1, 2.8, "elbow bends"},
    {"forearm_rotation", DofKind::Angle, -1.9, 1.9, "forearm supinates"},
    {"wrist_flexion", DofKind::Angle, -1.6, 1.6, "wrist extends, towards the back of the hand"},
    {"wrist_deviation", DofKind::Angle, -1.3, 1.3, "wrist bends to the thumb's side"},
    {"grip", DofKind::Ratio, 0.0, 1.0, "hand closes"},
    {"stick_x", DofKind::Ratio, -1.0, 1.0, "stick to the right"},
    {"stick_y", DofKind::Ratio, -1.0, 1.0, "stick ahead"},
    {"stick_twist", DofKind::Ratio, -1.0, 1.0, "stick twists to the left"},
    {"pedal_left", DofKind::Ratio, 0.0, 1.0, "left pedal is pressed"},
    {"pedal_right", DofKind::Ratio, 0.0, 1.0, "right pedal is pressed"},
}};

}  // namespace

const std::array<DofInfo, kDofCount>& dofTable() {
  return kTable;
}

std::optional<Dof> dofByName(std::string_view name) {
  const auto found =
      std::find_if(kTable.begin(), kTable.end(), [&](const DofInfo& d) { return d.name == name; });
  if (found == kTable.end()) return std::nullopt;
  return dofAt(static_cast<std::size_t>(found - kTable.begin()));
}

std::string_view unitName(DofKind kind) {
  switch (kind) {
    case DofKind::Length:
      return "m";
    case DofKind::Angle:
      return "rad";
    case DofKind::Ratio:
      return "";
  }
  assert(false);
  return "";
}

double resolution(DofKind kind) {
  switch (kind) {
    case DofKind::Length:
      return kMicrometre;
    case DofKind::Angle:
      return kAngleUnit;
    case DofKind::Ratio:
      return kRatioUnit;
  }
  assert(false);
  return 0.0;
}

std::int32_t unitsFromSi(DofKind kind, double si) {
  assert(std::isfinite(si));
  switch (kind) {
    case DofKind::Length:
      return micrometresFromMetres(si);
    case DofKind::Angle:
      return unitsFromRadians(si);
    case DofKind::Ratio:
      return unitsFromRatio(si);
  }
  assert(false);
  return 0;
}

double siFromUnits(DofKind kind, std::int32_t units) {
  switch (kind) {
    case DofKind::Length:
      return metresFromMicrometres(units);
    case DofKind::Angle:
      return radiansFromUnits(units);
    case DofKind::Ratio:
      return ratioFromUnits(units);
  }
  assert(false);
  return 0.0;
}

}  // namespace coherency
