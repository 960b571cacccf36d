// The rules as a whole: modes, the task's clock, beginnings, and states that go on the same whatever happens
// between.

#include <random>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/world/Scatter.h"
#include "common/world/Snapshot.h"
#include "tests/math/Random.h"
#include "tests/world/Support.h"

namespace coherency {
namespace {

using namespace worlds;

TEST(World, TheStickDrivesWhomTheModeSays) {
  const World world(tableWorld(0));
  WorldState state = world.initialState();
  run(world, state, driving({.y = -1.0}), 1000);
  EXPECT_GT(state.master.base.z_nm, 300'000'000);
  EXPECT_EQ(state.robot.base, world.model().robot->start);
  const BasePose master = state.master.base;
  state.mode = Mode::Robot;
  run(world, state, driving({.y = -1.0}), 1);
  EXPECT_NE(state.master.base, master) << "it rolls to a stop";
  run(world, state, driving({.y = -1.0}), 2000);
  EXPECT_EQ(speed(state.master), 0.0);
  EXPECT_LT(metresFromNanometres(state.master.base.z_nm - master.z_nm), 0.8 * 0.8 / (2 * 1.5) + 0.01);
  EXPECT_LT(state.robot.base.z_nm, world.model().robot->start.z_nm - 300'000'000) << "backwards is -z for it";
}

TEST(World, SwitchingModesMovesNothing) {
  const World world(tableWorld(3));
  WorldState state = world.initialState();
  run(world, state, driving({}), 50);
  const WorldState before = state;
  state.mode = Mode::Robot;
  run(world, state, driving({}), 1);
  WorldState expected = before;
  expected.mode = Mode::Robot;
  ++expected.tick;
  EXPECT_EQ(state, expected);
}

TEST(World, HasARobotModeOnlyWithARobot) {
  EXPECT_TRUE(World(tableWorld(0)).has(Mode::Robot));
  EXPECT_FALSE(World(plane()).has(Mode::Robot));
  EXPECT_TRUE(World(plane()).has(Mode::Operator));
}

TEST(World, WithoutDrivingTheStickMovesNothing) {
  WorldModel model = plane();
  model.driving = false;
  const World world(model);
  WorldState state = world.initialState();
  run(world, state, driving({.x = 1.0, .y = 1.0, .twist = 1.0}), 100);
  EXPECT_EQ(state.master.base, BasePose{});
  EXPECT_EQ(state.tick, 100U);
}

TEST(World, RefusesMoreThanAStateHolds) {
  WorldModel model = tableWorld(static_cast<int>(kMaxMovables) + 1);
  EXPECT_THROW(World{model}, std::invalid_argument);
  model = plane();
  model.doors.resize(kMaxDoors + 1);
  EXPECT_THROW(World{model}, std::invalid_argument);
}

TEST(World, TheTasksClockRunsFromTheFirstMotionOfTheStickToTheTower) {
  const World world(tableWorld(3));
  WorldState state = world.initialState();
  run(world, state, driving({}), 100);
  EXPECT_EQ(state.task, TaskClock{});
  run(world, state, driving({.twist = 0.2}), 1);
  EXPECT_EQ(state.task.started_tick, 101U);
  run(world, state, driving({}), 200);
  EXPECT_EQ(state.task.started_tick, 101U);
  const Coord3 base = place(state.movables[1]);
  state.movables[0] = letGo(base + Coord3{0.0, kEdge, 0.0});
  state.movables[2] = letGo(base + Coord3{0.0, 2 * kEdge, 0.0});
  run(world, state, driving({}), 10);
  EXPECT_TRUE(state.task.standing);
  EXPECT_EQ(state.task.towers, 1U);
  EXPECT_NEAR(static_cast<double>(state.task.done_tick), 302.0, 5.0);
  const std::uint64_t done = state.task.done_tick;
  state.movables[2] = letGo(base + Coord3{0.2, 0.0, 0.0});
  run(world, state, driving({}), 100);
  EXPECT_FALSE(state.task.standing);
  EXPECT_EQ(state.task.done_tick, done);
}

TEST(World, TheTasksClockStartsWhereThereIsNothingToGrasp) {
  const World world(plane());
  WorldState state = world.initialState();
  run(world, state, driving({.y = 1.0}), 3);
  EXPECT_EQ(state.task.started_tick, 1U);
}

TEST(World, ScattersClearOfOneAnotherAndWithinTheArea) {
  const World world(tableWorld(3));
  const ScatterArea area{-0.3, 0.3, -0.95, -0.55};
  for (std::uint64_t seed = 1; seed < 200; ++seed) {
    WorldState state = world.initialState();
    scatter(state, world.model(), area, seed);
    WorldState again = world.initialState();
    scatter(again, world.model(), area, seed);
    ASSERT_EQ(state, again);
    run(world, state, driving({}), 20);
    for (std::size_t i = 0; i < 3; ++i) {
      const Coord3 at = place(state.movables[i]);
      ASSERT_TRUE(at.x >= -0.3 && at.x <= 0.3 && at.z >= -0.95 && at.z <= -0.55);
      ASSERT_NEAR(at.y, kTableTop + kEdge / 2, 1e-8);
      for (std::size_t k = i + 1; k < 3; ++k) ASSERT_GT(norm(at - place(state.movables[k])), 1.8 * kEdge);
    }
  }
  WorldState state = world.initialState();
  EXPECT_THROW(scatter(state, world.model(), {0.0, 0.01, -0.7, -0.69}, 1), std::invalid_argument);
}

TEST(World, ScattersOntoWhatCarriesAndIntoNothing) {
  WorldModel model = tableWorld(3);
  model.solids.push_back(
      box(0.15, -0.75, 0.3, 0.4, kTableTop, kTableTop + 0.3));  // on the table's right half
  const World world(model);
  for (std::uint64_t seed = 1; seed < 50; ++seed) {
    WorldState state = world.initialState();
    scatter(state, model, {-0.4, 0.4, -0.95, -0.55}, seed);
    for (const Movable& m : state.movables) {
      const Coord3 at = place(m);
      ASSERT_FALSE(at.x > kEdge / -2 && at.x < 0.3 + kEdge / 2 && at.z > -0.95 - kEdge / 2 && at.z < -0.55)
          << at.x << ", " << at.z;
    }
  }
  const auto refusal = [&](const ScatterArea& area) {
    WorldState state = world.initialState();
    try {
      scatter(state, model, area, 1);
    } catch (const std::invalid_argument& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal({5e8, 5e8 + 1, 0, 1}).find("'block'"), std::string::npos) << "where nothing carries";
  EXPECT_NE(refusal({0.03, 0.27, -0.9, -0.6}).find("in the way"), std::string::npos);
}

/// Everything at once: sticks, arms and grips as if shaken.
class Shaking {
 public:
  explicit Shaking(std::uint64_t seed) : engine_(seed) {}
  const MotionSample& next() {
    if (left_-- > 0) return sample_;
    left_ = static_cast<int>(engine_() % 200);
    for (std::size_t i = index(Dof::ShoulderFlexion); i < kDofCount; ++i) {
      const DofInfo& dof = dofTable()[i];
      const double share = static_cast<double>(engine_() >> 11) * 0x1.0p-53;
      sample_.units[i] = unitsFromSi(dof.kind, dof.min + (dof.max - dof.min) * share);
    }
    sample_.valid = static_cast<DofMask>(engine_() | engine_()) & kAllDofs;  // three of four are valid
    return sample_;
  }

 private:
  std::mt19937_64 engine_;
  MotionSample sample_ = neutralSample(Rig{});
  int left_ = 0;
};

TEST(World, ASnapshotInTheMiddleChangesNothing) {
  const World world(tableWorld(4));
  Shaking through(7);
  Shaking interrupted(7);
  WorldState a = world.initialState();
  WorldState b = a;
  for (int i = 0; i < 20'000; ++i) {
    if (i % 200 == 100) a.mode = b.mode = i % 400 == 100 ? Mode::Robot : Mode::Operator;
    world.step(a, through.next(), kMillisecond);
    world.step(b, interrupted.next(), kMillisecond);
    if (i % 37 == 0) b = restore(snapshot(b), world);
  }
  EXPECT_EQ(a, b);
}

TEST(World, StaysAStateThatCanBe) {
  const World world(tableWorld(8));
  Shaking shaking(3);
  WorldState state = world.initialState();
  for (int i = 0; i < 20'000; ++i) {
    world.step(state, shaking.next(), kMillisecond);
    if (i % 100 == 0) {
      ASSERT_TRUE(isValid(state)) << i;
    }
  }
}

}  // namespace
}  // namespace coherency
