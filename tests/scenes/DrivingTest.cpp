// One drives about in the building: through its doors, and through nothing else.

#include <cmath>

#include <gtest/gtest.h>

#include "common/scene/Physical.h"
#include "common/scene/Senses.h"
#include "common/world/Driving.h"
#include "tests/scenes/Support.h"
#include "tests/world/Support.h"

namespace coherency {
namespace {

using namespace scenes;

constexpr std::int64_t kStep = 5'000'000;  // ns
constexpr double kClear = 2e-3;            // m, that neighbours may reach into each other

double x(const WorldState& state) {
  return metresFromNanometres(state.master.base.x_nm);
}
double z(const WorldState& state) {
  return metresFromNanometres(state.master.base.z_nm);
}

/// How deep a vehicle would stand in something, with the doors as the state has them; m.
double depth(const Scene& scene, const WorldState& state, const VehicleModel& vehicle, const BasePose& at,
             std::string* in = nullptr) {
  Surroundings surroundings;
  surroundings.solids = scene.world().model().solids;
  surroundings.doors = scene.world().model().doors;
  surroundings.openings = {state.doors.data(), state.doors.size()};
  return deepestContact(at, vehicle, surroundings, in);
}

/// The same of the master system where it is.
double depth(const Scene& scene, const WorldState& state, std::string* in) {
  return depth(scene, state, scene.world().model().master, state.master.base, in);
}

/// Turns towards a point and drives there; whether it gets there within the time it should take.
bool driveTo(const Scene& scene, WorldState& state, double to_x, double to_z) {
  for (int i = 0; i < 6000; ++i) {
    const double right = to_x - x(state);
    const double back = to_z - z(state);
    const double distance = std::hypot(right, back);
    if (distance < 0.08) return true;
    const double left =
        std::remainder(std::atan2(-right, -back) - radiansFromUnits(state.master.base.heading_units), kTurn);
    const double ahead = std::abs(left) < 0.1 ? std::min(1.0, 2.0 * distance) : 0.0;
    scene.world().step(state, worlds::driving({.y = ahead, .twist = std::clamp(2.0 * left, -1.0, 1.0)}),
                       kStep);
    std::string in;
    EXPECT_LT(depth(scene, state, &in), kClear) << in;
  }
  return false;
}

TEST(Building, OneDrivesThroughItsDoorsIntoEveryRoom) {
  const Scene scene(described("laboratory"), Rig{});
  WorldState state = scene.initialState();
  const auto doors = [&] { return std::vector<std::int32_t>(state.doors.begin(), state.doors.end()); };
  EXPECT_EQ(doors(), (std::vector<std::int32_t>{0, 0, 0})) << "all are closed";
  ASSERT_TRUE(driveTo(scene, state, 2.2, 0.73)) << "to the laboratory's door";
  ASSERT_TRUE(driveTo(scene, state, 4.8, 0.73)) << "into the corridor";
  ASSERT_TRUE(driveTo(scene, state, 4.8, 1.24)) << "to the office's door";
  ASSERT_TRUE(driveTo(scene, state, 8.0, 0.7)) << "into the office";
  worlds::run(scene.world(), state, worlds::driving({}), 3000);
  EXPECT_EQ(doors(), (std::vector<std::int32_t>{0, 0, 0})) << "all have closed again";
  ASSERT_TRUE(driveTo(scene, state, 7.2, 1.24)) << "to its door";
  ASSERT_TRUE(driveTo(scene, state, 4.8, 1.24)) << "back into the corridor";
  ASSERT_TRUE(driveTo(scene, state, 4.8, 4.93)) << "along it";
  ASSERT_TRUE(driveTo(scene, state, 2.4, 4.93)) << "into the meeting room";
  ASSERT_TRUE(driveTo(scene, state, 4.8, 4.93)) << "out again";
  ASSERT_TRUE(driveTo(scene, state, 4.8, -7.2)) << "to the window at the other end";
}

TEST(Building, DoorsOpenInTime) {
  const Scene scene(described("corridor"), Rig{});
  for (const DoorModel& door : scene.world().model().doors) {
    WorldState state = scene.initialState();
    const double at = metresFromNanometres(door.barrier.centre.x_nm);
    const double side = at < 4.76 ? 1.0 : -1.0;  // from the corridor
    state.master.base =
        basePose(4.76 - side * 0.3, metresFromNanometres(door.barrier.centre.z_nm), side * kTurn / 4);
    int steps = 0;
    while (std::abs(x(state) - 4.76) < 2.0 && ++steps < 2000)
      scene.world().step(state, worlds::driving({.y = 1.0}), kStep);
    EXPECT_LT(steps, 1000) << door.barrier.owner << ": 2.3 m take less than 5 s";
  }
}

struct Room {
  const char* name;
  double x, z;                        ///< a free place
  double min_x, max_x, min_z, max_z;  ///< its walls
};
constexpr Room kRooms[] = {{"laboratory", 0.0, 1.0, -3.5, 3.5, -3.0, 3.0},
                           {"corridor", 4.76, 2.4, 3.66, 5.86, -8.36, 8.36},
                           {"office", 8.2, 0.6, 6.02, 10.6, -2.6, 2.6},
                           {"meeting room", 2.35, 4.55, -2.7, 3.5, 3.16, 8.36}};

TEST(Building, OneDrivesThroughNoWallClosedDoorOrFurniture) {
  const Scene scene(described("laboratory"), Rig{});
  for (const Room& room : kRooms) {
    for (int way = 0; way < 24; ++way) {
      WorldState state = scene.initialState();
      state.master.base = basePose(room.x, room.z, kTurn * way / 24);
      for (int i = 0; i < 1200; ++i) {
        for (std::int32_t& door : state.doors) door = 0;
        scene.world().step(state, worlds::driving({.y = 1.0, .boost = 1.0}), kStep);
        std::string in;
        ASSERT_LT(depth(scene, state, &in), kClear) << room.name << ", " << way * 15 << " degrees: " << in;
      }
      EXPECT_TRUE(x(state) > room.min_x && x(state) < room.max_x && z(state) > room.min_z &&
                  z(state) < room.max_z)
          << "out of the " << room.name << " by " << way * 15 << " degrees";
    }
  }
}

/// A disc that has to do with what is near a point and as high.
VehicleModel probe(double radius, double y) {
  VehicleModel model;
  model.footprint = {{0.0, 0.0, radius, y - 0.06, y + 0.06}};
  return model;
}

bool bends(const VRObject& object) {
  const auto* surface = object.attribute<Surface>();
  return surface != nullptr && surface->material == "leaf";
}

/// Whatever is drawn from the floor to the height of a head stops who drives, before they are far into it.
TEST(Building, WhatIsDrawnStopsWhoDrives) {
  constexpr double kNear = 0.18;  // m
  const Scene scene(described("laboratory"), Rig{});
  const WorldState state = scene.initialState();
  for (const Room& room : kRooms) {
    forEachDrawn(
        scene, std::string("/") + room.name + "/", [&](const VRObject& object, const TransformMatrix& at) {
          if (bends(object) || object.path().find("facade") != std::string::npos) return;
          for (const Coord3& vertex : object.faces()->vertices) {
            const Coord3 p = at.point(vertex);
            const bool inside = p.x > room.min_x && p.x < room.max_x && p.z > room.min_z && p.z < room.max_z;
            if (!inside || p.y < 0.08 || p.y > 1.3) continue;
            ASSERT_GT(depth(scene, state, probe(kNear, p.y), basePose(p.x, p.z, 0.0)), 0.0)
                << object.path() << " at x " << p.x << ", y " << p.y << ", z " << p.z;
          }
        });
  }
}

TEST(Building, EveryPieceOfFurnitureStops) {
  const Scene scene(described("laboratory"), Rig{});
  const WorldState state = scene.initialState();
  for (const char* name :
       {"table",       "desk",     "meeting table", "workbench", "chair",         "swivel chair",
        "armchair",    "bench",    "bookshelf",     "cabinet",   "rack",          "coat stand",
        "plant",       "radiator", "computer",      "waste bin", "standing lamp", "fire extinguisher",
        "locked door", "lift"}) {
    const auto pieces = called(scene, name);
    EXPECT_FALSE(pieces.empty()) << name;
    for (const VRObject* piece : pieces) {
      const Coord3 at = piece->globalTransform().point(extentOf(*piece, "").middle());
      EXPECT_GT(depth(scene, state, scene.world().model().master, basePose(at.x, at.z, 0.0)), 0.2)
          << piece->path();
    }
  }
}

TEST(Building, KneesGoUnderTablesAndDesks) {
  const Scene scene(described("laboratory"), Rig{});
  const WorldState state = scene.initialState();
  const VehicleModel& master = scene.world().model().master;
  EXPECT_LT(depth(scene, state, master, scene.description().workplace), kClear);
  // With the knees between the drawers and the side of a desk; a chair that is in the way would have been
  // moved.
  VehicleModel knees = master;
  knees.footprint = {{0.0, 0.0, 0.22, 0.0, 0.62}};
  for (const VRObject* desk : called(scene, "desk")) {
    const Coord3 at = desk->globalTransform().point({-0.05, 0.0, 0.10});
    EXPECT_LT(depth(scene, state, knees, basePose(at.x, at.z, 0.0)), kClear) << desk->path();
  }
}

}  // namespace
}  // namespace coherency
