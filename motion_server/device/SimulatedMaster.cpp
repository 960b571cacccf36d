#include "motion_server/device/SimulatedMaster.h"

#include <algorithm>

#include "common/body/Posture.h"

namespace coherency {

namespace {

constexpr double kLeanSway = 0.008;   // rad
constexpr double kHeadSway = 0.012;   // rad
constexpr double kJointSway = 0.006;  // rad

}  // namespace

SimulatedMaster::Sway::Sway(std::uint64_t seed)
    : lean_forward(seed, 1, 0.8),
      lean_right(seed, 2, 0.7),
      yaw(seed, 3, 1.5),
      pitch(seed, 4, 1.7),
      roll(seed, 5, 1.3) {
  for (std::uint64_t j = 0; j < kArmJointCount; ++j) joints.emplace_back(seed, 6 + j, 3.0);
}

SimulatedMaster::SimulatedMaster(const Task& task, const Rig& rig, std::uint64_t seed)
    : body_(rig), kinematics_(rig), operator_(task, rig, seed), sway_(seed) {
  feel({neutralPosture(rig), kAllDofs, 0});
}

std::optional<MasterReading> SimulatedMaster::read(std::int64_t elapsed_ns, const WorldState& world) {
  const double t = static_cast<double>(elapsed_ns) * 1e-9;
  operator_.advance(t, world, felt_);
  const Driver& driver = operator_.driver();
  const ReachPose pose = operator_.arm().at(t);
  const Lean lean{pose.lean.forward + driver.leanForward() + kLeanSway * sway_.lean_forward.at(t),
                  pose.lean.right + driver.leanRight() + kLeanSway * sway_.lean_right.at(t)};
  YawPitchRoll attitude = operator_.gaze().at(t);
  attitude.yaw += kHeadSway * sway_.yaw.at(t);
  attitude.pitch += kHeadSway * sway_.pitch.at(t);
  attitude.roll += kHeadSway * sway_.roll.at(t);
  const Coord3 head = body_.headCentre(lean, attitude);

  MasterReading reading;
  reading.device_time_us = elapsed_ns / 1000;
  const auto set = [&](Dof dof, double si) {
    reading.si[index(dof)] = std::clamp(si, info(dof).min, info(dof).max);
  };
  set(Dof::HeadX, head.x);
  set(Dof::HeadY, head.y);
  set(Dof::HeadZ, head.z);
  set(Dof::HeadYaw, attitude.yaw);
  set(Dof::HeadPitch, attitude.pitch);
  set(Dof::HeadRoll, attitude.roll);
  for (std::size_t j = 0; j < kArmJointCount; ++j) {
    set(dofAt(index(Dof::ShoulderFlexion) + j), pose.joints[j] + kJointSway * sway_.joints[j].at(t));
  }
  set(Dof::Grip, operator_.arm().grip(t));
  set(Dof::StickX, driver.stickX());
  set(Dof::StickY, driver.stickY());
  set(Dof::StickTwist, driver.stickTwist());
  set(Dof::PedalLeft, driver.pedalLeft());
  set(Dof::PedalRight, driver.pedalRight());
  feel(reading);
  return reading;
}

/// Where the hand of this reading is, as the operator's own joints tell it.
void SimulatedMaster::feel(const MasterReading& reading) {
  MotionSample sample;
  for (std::size_t i = 0; i < kDofCount; ++i)
    sample.units[i] = unitsFromSi(info(dofAt(i)).kind, reading.si[i]);
  const Posture p = posture(body_.rig(), kinematics_, sample);
  felt_ = p.t_body_shoulder * p.right_arm.t_shoulder_hand;
}

}  // namespace coherency
