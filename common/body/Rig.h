#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "common/math/Coord3.h"
#include "common/motion/MotionSample.h"

namespace coherency {

/// The operator's measures: the virtual human is exactly this size (paper, section II). Metres and radians.
/// Body frame: origin on the floor under the hips, y up, -z ahead.
struct Rig {
  std::string name = "default";
  double eye_distance = 0.064;  ///< between the pupils
  double eye_forward = 0.085;   ///< head centre to the eyes' plane, ahead
  double eye_up = 0.03;         ///< head centre to the eyes, up
  double neck_length = 0.14;    ///< neck base to head centre, up
  double neck_back = 0.03;      ///< neck base behind head centre
  double trunk_length = 0.52;   ///< hip to neck base, sitting upright
  double shoulder_half_width = 0.19;
  double shoulder_drop = 0.05;                     ///< shoulder joints below neck base
  double shoulder_tilt_up = 0.4363323129985824;    ///< of the arm's base axes (25 deg)
  double shoulder_tilt_back = 0.5235987755982988;  ///< (30 deg)
  double upper_arm = 0.29;
  double forearm = 0.26;
  double hand = 0.09;         ///< wrist to the middle of the palm
  double seat_height = 0.50;  ///< floor to hip joint
  double hip_half_width = 0.09;
  double thigh = 0.43;
  double shin = 0.42;
  double foot = 0.25;
  double robot_scale = 1.0;  ///< the slave robot's size over the operator's
  bool operator==(const Rig&) const = default;
};

/// One row a measure: what configuration reads and refuses by.
struct RigField {
  std::string_view name;
  double Rig::*value;
  double min;
  double max;
};
const std::vector<RigField>& rigFields();

/// Throws std::domain_error naming the first measure that is not finite or out of its range, and the range.
void validate(const Rig& rig);

/// The slave robot's measures: the operator's times robot_scale, so that their joints mean the same.
Rig robotRig(const Rig& rig);

/// Head centre in the body frame when sitting upright and looking ahead.
Coord3 neutralHead(const Rig& rig);
/// All DOFs in SI for an operator who sits upright, looks ahead, and rests the right forearm.
std::array<double, kDofCount> neutralPosture(const Rig& rig);
/// The same as a sample; no DOF of it is valid, as nothing was measured.
MotionSample neutralSample(const Rig& rig);

}  // namespace coherency
