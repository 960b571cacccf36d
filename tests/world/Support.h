#pragma once

#include <cmath>

#include "common/math/FixedPoint.h"
#include "common/world/World.h"

/// Worlds and samples made by hand for the tests of this folder.
namespace coherency::worlds {

inline constexpr std::int64_t kMillisecond = 1'000'000;
inline constexpr double kEdge = 0.055;
inline constexpr double kTableTop = 0.72;

struct Controls {
  double x = 0, y = 0, twist = 0, brake = 0, boost = 0;
};

inline MotionSample driving(const Controls& c) {
  MotionSample sample = neutralSample(Rig{});
  sample.valid = kAllDofs;
  sample.units[index(Dof::StickX)] = unitsFromRatio(c.x);
  sample.units[index(Dof::StickY)] = unitsFromRatio(c.y);
  sample.units[index(Dof::StickTwist)] = unitsFromRatio(c.twist);
  sample.units[index(Dof::PedalLeft)] = unitsFromRatio(c.brake);
  sample.units[index(Dof::PedalRight)] = unitsFromRatio(c.boost);
  return sample;
}

inline SolidBox box(double x, double z, double width, double depth, double low, double high,
                    double heading = 0.0) {
  SolidBox b;
  b.centre = basePose(x, z, 0.0);
  b.centre.y_nm = nanometresFromMetres(low);
  b.half_x = width / 2;
  b.half_z = depth / 2;
  b.height = high - low;
  const TransformMatrix turn = TransformMatrix::rotationY(heading);
  b.cosine = turn(0, 0);
  b.sine = turn(0, 2);
  b.owner = "a box";
  return b;
}

/// One disc of radius 0.4 m that drives on an empty plane.
inline WorldModel plane() {
  WorldModel model;
  model.master.footprint = {{0.0, 0.0, 0.4, 0.0, 1.2}};
  return model;
}

/// A table ahead of the origin with `blocks` cubes in a row on it, 0.12 m apart, and a robot behind it.
inline WorldModel tableWorld(int blocks) {
  WorldModel model = plane();
  model.solids = {box(0.0, -0.8, 1.4, 0.7, 0.66, kTableTop)};
  VehicleModel robot = model.master;
  robot.start = basePose(0.0, -1.6, kTurn / 2);
  robot.rig = robotRig(Rig{});
  model.robot = robot;
  for (int i = 0; i < blocks; ++i) {
    MovableModel m;
    m.edge = kEdge;
    m.start = basePose(-0.1 + 0.12 * i, -0.6, 0.0);
    m.start.y_nm = nanometresFromMetres(kTableTop + kEdge / 2);
    m.name = "block";
    model.movables.push_back(m);
  }
  return model;
}

/// Lets `steps` milliseconds pass.
inline void run(const World& world, WorldState& state, const MotionSample& sample, int steps) {
  for (int i = 0; i < steps; ++i) world.step(state, sample, kMillisecond);
}

inline double speed(const Vehicle& v) {
  return std::hypot(v.velocity_right_um, v.velocity_ahead_um) * kMicrometre;
}

inline Coord3 place(const Movable& m) {
  return {metresFromNanometres(m.x_nm), metresFromNanometres(m.y_nm), metresFromNanometres(m.z_nm)};
}

/// A movable somewhere in the air or wherever it is put, let go.
inline Movable letGo(const Coord3& at, const Quaternion& attitude = {}) {
  Movable m;
  m.x_nm = nanometresFromMetres(at.x);
  m.y_nm = nanometresFromMetres(at.y);
  m.z_nm = nanometresFromMetres(at.z);
  setAttitude(m, attitude);
  m.resting = false;
  return m;
}

}  // namespace coherency::worlds
