#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/world/Driving.h"
#include "tests/math/Random.h"
#include "tests/world/Support.h"

namespace coherency {
namespace {

using namespace worlds;

// Built with sanitizers, a step takes ten times as long: then fewer of them.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::int64_t kManySteps = 10'000'000;
#else
constexpr std::int64_t kManySteps = 1'000'000'000;
#endif

MotionSample anyDriving() {
  return driving({random::real(-1, 1), random::real(-1, 1), random::real(-1, 1), random::real(0, 1),
                  random::real(0, 1)});
}

/// The vehicle after `steps` milliseconds on an empty plane.
Vehicle driven(Vehicle vehicle, const DriveControls& controls, std::int64_t steps) {
  const VehicleModel model = plane().master;
  for (std::int64_t i = 0; i < steps; ++i) drive(vehicle, controls, kMillisecond, model, {});
  return vehicle;
}

TEST(Driving, ABillionStepsAheadEndWhereIntegersSay) {
  const Vehicle end = driven({}, {.ahead = 1.0}, kManySteps);
  // 1500 um/s more each step up to 800000: 533 steps of rising speed, then the full one; one um/s is one nm a
  // ms.
  std::int64_t expected = 0;
  for (std::int64_t i = 1; i < 1000; ++i) expected += std::min<std::int64_t>(1500 * i, 800'000);
  expected += (kManySteps - 999) * 800'000;
  EXPECT_EQ(end.base.z_nm, -expected);
  EXPECT_EQ(end.base.x_nm, 0);
  EXPECT_EQ(end.base.heading_units, 0);
}

TEST(Driving, ABillionStepsOfTurningLoseNothing) {
  const DriveControls turning{.twist = 1.0};
  const Vehicle steady = driven({}, turning, 2000);
  const Vehicle end = driven(steady, turning, kManySteps);
  const std::int64_t each = std::llround(steady.turn_rate_units * 1e-3);
  EXPECT_EQ(static_cast<std::uint32_t>(end.base.heading_units),
            static_cast<std::uint32_t>(steady.base.heading_units) +
                static_cast<std::uint32_t>(kManySteps * each));  // modulo 2^32: more than 100 000 turns
  EXPECT_EQ(end.base.x_nm, 0);
  EXPECT_EQ(end.base.z_nm, 0);
}

TEST(Driving, DirectionsAreAsDocumented) {
  const auto after = [](const DriveControls& c, double heading) {
    Vehicle vehicle;
    vehicle.base.heading_units = unitsFromRadians(heading);
    return driven(vehicle, c, 1000).base;
  };
  EXPECT_LT(after({.ahead = 1}, 0).z_nm, -300'000'000);
  EXPECT_GT(after({.right = 1}, 0).x_nm, 300'000'000);
  EXPECT_GT(after({.twist = 1}, 0).heading_units, 0);
  EXPECT_LT(after({.ahead = 1}, kTurn / 4).x_nm, -300'000'000) << "turned left, ahead is -x";
  EXPECT_NEAR(static_cast<double>(after({.ahead = 1}, kTurn / 4).z_nm), 0.0, 1000.0);
  const Coord3 ahead = transform(after({}, 0.3)).vector({0, 0, -1});
  EXPECT_NEAR(ahead.x, -std::sin(0.3), 1e-9);
}

RC_GTEST_PROP(Driving, AcceleratesWithinItsLimit, ()) {
  const DriveLimits limits;
  Vehicle vehicle;
  vehicle.velocity_ahead_um = *rc::gen::inRange(-1'000'000, 1'000'000);
  vehicle.velocity_right_um = *rc::gen::inRange(-1'000'000, 1'000'000);
  const Vehicle before = vehicle;
  const MotionSample sample = anyDriving();
  vehicle = driven(vehicle, driveControls(sample), 1);
  const double change = std::hypot(vehicle.velocity_ahead_um - before.velocity_ahead_um,
                                   vehicle.velocity_right_um - before.velocity_right_um) *
                        1e-6;
  const double brake = sample.si(Dof::PedalLeft);
  RC_ASSERT(change <= (limits.acceleration + brake * (limits.brake - limits.acceleration)) * 1e-3 + 1.5e-6);
}

double metresToStop(double brake, DofMask valid) {
  const Vehicle moving = driven({}, {.ahead = 1.0}, 2000);
  MotionSample sample = driving({.y = brake > 0 ? 0.0 : 1.0, .brake = brake});
  sample.valid = valid;
  const Vehicle end = driven(moving, driveControls(sample), 5000);
  EXPECT_EQ(speed(end), 0.0);
  return static_cast<double>(moving.base.z_nm - end.base.z_nm) * 1e-9;
}

TEST(Driving, BrakesAndComesToRestWithoutAStick) {
  const double with_brake = metresToStop(1.0, kAllDofs);
  const double stick_lost = metresToStop(0.0, kAllDofs & ~mask(Dof::StickY));
  EXPECT_NEAR(with_brake, 0.8 * 0.8 / (2 * 6.0), 0.005);  // v^2 / 2a
  EXPECT_NEAR(stick_lost, 0.8 * 0.8 / (2 * 1.5), 0.005);
}

TEST(Driving, BoostIsFaster) {
  EXPECT_NEAR(speed(driven({}, {.ahead = 1.0}, 3000)), 0.8, 1e-6);
  EXPECT_NEAR(speed(driven({}, {.ahead = 1.0, .boost = 1.0}, 3000)), 1.6, 1e-6);
}

TEST(Driving, TheWorldEnds) {
  Vehicle vehicle;
  vehicle.base.z_nm = -kWorldLimitNm + 1'000'000;
  vehicle = driven(vehicle, {.ahead = 1.0}, 5000);
  EXPECT_EQ(vehicle.base.z_nm, -kWorldLimitNm);
  vehicle = driven(vehicle, {.ahead = -1.0}, 5000);
  EXPECT_GT(vehicle.base.z_nm, -kWorldLimitNm + 2'000'000'000) << "and one can turn back";
}

/// A room of 4 m by 4 m with a pillar in it, somewhere in the world and turned.
struct Room {
  Room(double x, double z, double heading) : model(plane()) {
    const auto add = [&](double dx, double dz, double width, double depth, double turn) {
      const TransformMatrix t = TransformMatrix::rotationY(heading);
      const Coord3 at = t.vector({dx, 0.0, dz});
      model.solids.push_back(box(x + at.x, z + at.z, width, depth, 0.0, 2.5, heading + turn));
    };
    for (const double side : {-1.0, 1.0}) {
      add(side * 2.1, 0.0, 0.2, 4.4, 0.0);
      add(0.0, side * 2.1, 4.4, 0.2, 0.0);
    }
    add(0.7, -0.6, 0.3, 0.5, 0.4);
    const Coord3 start = TransformMatrix::rotationY(heading).vector({-0.8, 0.0, 0.8});
    vehicle.base = basePose(x + start.x, z + start.z, heading);
  }
  Surroundings around() const { return {model.solids}; }
  WorldModel model;
  Vehicle vehicle;
};

RC_GTEST_PROP(Driving, NeverGoesThroughAnythingNorExceedsItsLimits, ()) {
  const double far = *rc::gen::element(0.0, 1e3, 1e6, 9e8);
  Room room(random::real(-1, 1) * far, random::real(-1, 1) * far, random::real(-3, 3));
  room.model.master.footprint.push_back({0.0, -0.5, 0.25, 0.0, 0.6});
  const DriveLimits& limits = room.model.master.limits;
  Vehicle& v = room.vehicle;
  for (int stretch = 0; stretch < 6; ++stretch) {
    const DriveControls controls = driveControls(anyDriving());
    for (int i = 0; i < 700; ++i) {
      const Vehicle before = v;
      drive(v, controls, kMillisecond, room.model.master, room.around());
      RC_ASSERT(deepestContact(v.base, room.model.master, room.around(), nullptr) <= 2e-9);
      RC_ASSERT(speed(v) <= limits.speed * limits.boost + 1e-5);
      RC_ASSERT(std::abs(v.turn_rate_units) * kAngleUnit <= limits.turn_rate + 1e-6);
      const double moved = std::hypot(static_cast<double>(v.base.x_nm - before.base.x_nm),
                                      static_cast<double>(v.base.z_nm - before.base.z_nm));
      // Pushed out of a corner it may be faster than it drives, but not much.
      RC_ASSERT(moved <= (2.0 * limits.speed * limits.boost + 2.0) * 1e6 + 10.0);
    }
  }
}

TEST(Driving, SlidesAlongAWall) {
  WorldModel model = plane();
  model.solids = {box(-1.0, 0.0, 0.2, 200.0, 0.0, 2.5)};  // its face at x = -0.9
  Vehicle v;
  v.base.heading_units = unitsFromRadians(kTurn / 8);
  const auto drive1 = [&](int steps) {
    for (int i = 0; i < steps; ++i) drive(v, {.ahead = 1.0}, kMillisecond, model.master, {model.solids});
  };
  drive1(3000);
  EXPECT_NEAR(static_cast<double>(v.base.x_nm) * 1e-9, -0.9 + 0.4, 1e-8);
  const std::int64_t before = v.base.z_nm;
  drive1(1000);
  EXPECT_NEAR(static_cast<double>(before - v.base.z_nm) * 1e-9, 0.8 / std::sqrt(2.0), 0.01)
      << "the speed along the wall is kept";
}

TEST(Driving, WhatIsLowGoesUnderWhatIsHigh) {
  WorldModel model = plane();
  model.master.footprint = {{0.0, 0.0, 0.4, 0.0, 1.2}, {0.0, -0.6, 0.3, 0.0, 0.6}};
  model.solids = {box(0.0, -2.0, 1.4, 0.7, 0.66, 0.72)};
  Vehicle v;
  for (int i = 0; i < 5000; ++i) drive(v, {.ahead = 1.0}, kMillisecond, model.master, {model.solids});
  EXPECT_NEAR(static_cast<double>(v.base.z_nm) * 1e-9, -2.0 + 0.35 + 0.4, 1e-6)
      << "the feet are under the table, the seat stops at its edge";
}

TEST(Driving, WhatStandsInSomethingIsPushedOutGently) {
  WorldModel model = plane();
  model.solids = {box(0.5, 0.0, 1.0, 1.0, 0.0, 2.0)};  // its face at x = 0
  Vehicle v;                                           // 0.4 m deep in it
  double deepest = deepestContact(v.base, model.master, {model.solids}, nullptr);
  EXPECT_NEAR(deepest, 0.4, 1e-9);
  for (int i = 0; i < 400; ++i) {
    const Vehicle before = v;
    drive(v, {.ahead = 0.1}, kMillisecond, model.master, {model.solids});
    const double now = deepestContact(v.base, model.master, {model.solids}, nullptr);
    ASSERT_LE(now, deepest + 1e-9);
    // 2 m/s, and as much as it drives itself.
    ASSERT_LE(std::abs(v.base.x_nm - before.base.x_nm), 2'110'000) << "no jump";
    deepest = now;
  }
  EXPECT_LE(deepest, 2e-9);
}

TEST(Driving, TwoVehiclesDoNotMeet) {
  WorldModel model = plane();
  Vehicle other;
  other.base = basePose(0.1, -2.0, 0.0);
  Vehicle v;
  Surroundings around;
  around.other = &other;
  around.other_model = &model.master;
  for (int i = 0; i < 4000; ++i) {
    drive(v, {.ahead = 1.0}, kMillisecond, model.master, around);
    ASSERT_GE(std::hypot(static_cast<double>(v.base.x_nm - other.base.x_nm),
                         static_cast<double>(v.base.z_nm - other.base.z_nm)),
              0.8e9 - 3.0);
  }
}

TEST(Doors, OpenForWhoComesAndCloseBehindThem) {
  WorldModel model = plane();
  model.solids = {box(-2.55, -3.0, 4.0, 0.2, 0.0, 2.5), box(2.55, -3.0, 4.0, 0.2, 0.0, 2.5)};
  model.doors = {{box(0.0, -3.0, 1.1, 0.1, 0.0, 2.1), 1.3}};
  const World world(model);
  WorldState state = world.initialState();
  ASSERT_EQ(state.doors.size(), 1U);
  run(world, state, driving({}), 500);
  EXPECT_EQ(state.doors[0], 0) << "nobody is there";
  bool opened = false;
  for (int i = 0; i < 12'000 && state.master.base.z_nm > -6'000'000'000; ++i) {
    run(world, state, driving({.y = 1.0}), 1);
    const std::int64_t z = state.master.base.z_nm;
    // In the doorway the door stands open.
    if (z < -2'600'000'000 && z > -3'400'000'000) {
      ASSERT_GE(state.doors[0], kDoorPassable);
    }
    opened = opened || state.doors[0] == kDoorOpen;
  }
  EXPECT_TRUE(opened);
  EXPECT_LE(state.master.base.z_nm, -6'000'000'000) << "one is through";
  run(world, state, driving({}), 3000);
  EXPECT_EQ(state.doors[0], 0) << "and it has closed";
}

TEST(Doors, OneThatIsTooSlowStopsWhoIsTooFast) {
  WorldModel model = plane();
  model.doors = {{box(0.0, -1.0, 4.0, 0.1, 0.0, 2.1), 0.2}};  // opens when one all but touches it
  const World world(model);
  WorldState state = world.initialState();
  for (int i = 0; i < 5000; ++i) {
    const std::int32_t opening = state.doors[0];
    run(world, state, driving({.y = 1.0}), 1);
    if (opening < kDoorPassable) {
      ASSERT_GE(state.master.base.z_nm, -550'000'001);
    }
  }
}

}  // namespace
}  // namespace coherency
