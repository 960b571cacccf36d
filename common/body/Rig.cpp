#include "common/body/Rig.h"

#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace coherency {

const std::vector<RigField>& rigFields() {
  static const std::vector<RigField> fields = {
      {"eye_distance", &Rig::eye_distance, 0.03, 0.2},
      {"eye_forward", &Rig::eye_forward, -0.1, 0.15},
      {"eye_up", &Rig::eye_up, -0.07, 0.07},
      {"neck_length", &Rig::neck_length, 0.0, 0.5},
      {"neck_back", &Rig::neck_back, -0.2, 0.3},
      {"trunk_length", &Rig::trunk_length, 0.1, 1.5},
      {"shoulder_half_width", &Rig::shoulder_half_width, 0.08, 0.5},
      {"shoulder_drop", &Rig::shoulder_drop, -0.1, 0.4},
      {"shoulder_tilt_up", &Rig::shoulder_tilt_up, -1.0, 1.0},
      {"shoulder_tilt_back", &Rig::shoulder_tilt_back, -1.0, 1.0},
      {"upper_arm", &Rig::upper_arm, 0.1, 1.0},
      {"forearm", &Rig::forearm, 0.1, 1.0},
      {"hand", &Rig::hand, 0.01, 0.3},
      {"seat_height", &Rig::seat_height, 0.0, 1.5},
      {"hip_half_width", &Rig::hip_half_width, 0.02, 0.4},
      {"thigh", &Rig::thigh, 0.1, 1.0},
      {"shin", &Rig::shin, 0.1, 1.0},
      {"foot", &Rig::foot, 0.05, 0.6},
      {"robot_scale", &Rig::robot_scale, 0.5, 2.0},
  };
  return fields;
}

void validate(const Rig& rig) {
  for (const RigField& field : rigFields()) {
    const double value = rig.*field.value;
    if (std::isfinite(value) && value >= field.min && value <= field.max) continue;
    std::ostringstream text;
    text << "rig '" << rig.name << "': " << field.name << " is " << value << ", must be within " << field.min
         << " to " << field.max;
    throw std::domain_error(text.str());
  }
}

Rig robotRig(const Rig& rig) {
  Rig robot = rig;
  robot.name = rig.name + "'s robot";
  for (const RigField& field : rigFields())
    if (!field.name.starts_with("shoulder_tilt")) robot.*field.value *= rig.robot_scale;
  robot.robot_scale = 1.0;
  return robot;
}

Coord3 neutralHead(const Rig& rig) {
  return {0.0, rig.seat_height + rig.trunk_length + rig.neck_length, -rig.neck_back};
}

std::array<double, kDofCount> neutralPosture(const Rig& rig) {
  std::array<double, kDofCount> si{};
  const Coord3 head = neutralHead(rig);
  si[index(Dof::HeadX)] = head.x;
  si[index(Dof::HeadY)] = head.y;
  si[index(Dof::HeadZ)] = head.z;
  // The upper arm hangs (the base's tilt undone), the elbow is square, the palm lies on the arm rest.
  si[index(Dof::ShoulderAbduction)] = -rig.shoulder_tilt_up;
  si[index(Dof::ShoulderRotation)] = rig.shoulder_tilt_back;
  si[index(Dof::ElbowFlexion)] = std::numbers::pi / 2;
  si[index(Dof::ForearmRotation)] = -std::numbers::pi / 3;
  return si;
}

MotionSample neutralSample(const Rig& rig) {
  MotionSample neutral;
  const auto si = neutralPosture(rig);
  for (std::size_t i = 0; i < kDofCount; ++i) neutral.units[i] = unitsFromSi(info(dofAt(i)).kind, si[i]);
  return neutral;
}

}  // namespace coherency
