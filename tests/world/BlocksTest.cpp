#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/world/Blocks.h"
#include "tests/math/Random.h"
#include "tests/world/Support.h"

namespace coherency {
namespace {

using namespace worlds;

constexpr double kRest = kTableTop + kEdge / 2;  // height of the centre on the table

/// Lets time pass until nothing moves; milliseconds that took.
int settle(WorldState& state, const WorldModel& model, int patience_ms = 6000) {
  for (int i = 0; i < patience_ms; ++i)
    if (!stepBlocks(state, model, kMillisecond)) return i;
  return patience_ms;
}

double lean(const Movable& m) {
  const TransformMatrix t = rotation(attitude(m));
  double most = 0.0;
  for (int axis = 0; axis < 3; ++axis) most = std::max(most, std::abs(t(1, axis)));
  return std::acos(std::min(1.0, most));
}

struct OnTable {
  explicit OnTable(int blocks) : world(tableWorld(blocks)), state(world.initialState()) {
    settle(state, world.model());
  }
  int drop(std::size_t which, const Coord3& at, const Quaternion& attitude = {}) {
    state.movables[which] = letGo(at, attitude);
    return settle(state, world.model());
  }
  Coord3 at(std::size_t which) const { return place(state.movables[which]); }
  World world;
  WorldState state;
};

TEST(Blocks, StandWhereTheSceneHasThem) {
  const World world(tableWorld(3));
  WorldState state = world.initialState();
  settle(state, world.model());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(place(state.movables[i]).y, kRest, 1e-9);
    EXPECT_NEAR(place(state.movables[i]).x, -0.1 + 0.12 * static_cast<double>(i), 1e-9);
    EXPECT_TRUE(state.movables[i].resting);
  }
}

TEST(Blocks, FallAsThingsDo) {
  OnTable t(1);
  t.state.movables[0] = letGo({0.0, kRest + 0.5, -0.6});
  int ms = 0;
  while (place(t.state.movables[0]).y > kRest + 1e-9 && ms < 1000)
    stepBlocks(t.state, t.world.model(), kMillisecond), ++ms;
  EXPECT_NEAR(ms, std::sqrt(2 * 0.5 / 9.80665) * 1e3, 2.0);
  EXPECT_LT(settle(t.state, t.world.model()), 5);
}

TEST(Blocks, FallOnTheFloorBesideTheTable) {
  OnTable t(1);
  t.drop(0, {1.5, 1.0, -0.6});
  EXPECT_NEAR(t.at(0).y, kEdge / 2, 1e-9);
  EXPECT_TRUE(t.state.movables[0].resting);
}

TEST(Blocks, StackWhereTheyAreSupported) {
  OnTable t(3);
  for (const double off : {0.0, 0.01, 0.02, 0.026}) {
    const Coord3 below = t.at(0);
    t.drop(1, {below.x + off, below.y + kEdge + 0.03, below.z});
    EXPECT_NEAR(t.at(1).y, kRest + kEdge, 1e-8) << off;
    EXPECT_NEAR(t.at(1).x, below.x + off, 1e-9) << "it stays where it was put";
  }
  t.drop(2, t.at(1) + Coord3{0.0, kEdge + 0.01, 0.01});
  EXPECT_NEAR(t.at(2).y, kRest + 2 * kEdge, 1e-8);
  EXPECT_TRUE(towerStands(t.state, t.world.model()));
}

TEST(Blocks, ToppleOffWhereTheyAreNot) {
  for (const double off : {0.029, 0.035, 0.045, 0.052}) {
    OnTable t(2);
    const Coord3 below = t.at(1);
    t.drop(0, {below.x + off, below.y + kEdge + 0.002, below.z});
    EXPECT_NEAR(t.at(0).y, kRest, 1e-8) << off << ": it lies on the table";
    EXPECT_GT(t.at(0).x, below.x + kEdge - 1e-3) << "beside the other, on the side it hung over";
    EXPECT_NEAR(norm(t.at(1) - below), 0.0, 1e-9) << "which has not moved";
  }
}

TEST(Blocks, ToppleOffTheTablesEdge) {
  OnTable t(1);
  t.drop(0, {0.7 + 0.01, kRest + 0.001, -0.6});  // the table's edge is at 0.7
  EXPECT_NEAR(t.at(0).y, kEdge / 2, 1e-8);
  t.drop(0, {0.7 - 0.01, kRest + 0.001, -0.6});
  EXPECT_NEAR(t.at(0).y, kRest, 1e-8) << "with its centre over the table it stays";
}

TEST(Blocks, ABridgeOverTwoCarries) {
  OnTable t(3);
  t.drop(0, {-0.04, kRest, -0.6});
  t.drop(1, {0.04, kRest, -0.6});
  t.drop(2, {0.0, kRest + kEdge + 0.01, -0.6});  // its centre is over the gap between the two
  EXPECT_NEAR(t.at(2).y, kRest + kEdge, 1e-8);
  EXPECT_NEAR(t.at(2).x, 0.0, 1e-9);
}

TEST(Blocks, FallWhenWhatCarriesThemIsTaken) {
  OnTable t(3);
  const Coord3 below = t.at(0);
  t.drop(1, below + Coord3{0.0, kEdge, 0.0});
  t.drop(2, below + Coord3{0.0, 2 * kEdge, 0.0});
  t.state.movables[0].holder = Holder::OperatorHand;
  wakeUnsupported(t.state, t.world.model());
  EXPECT_FALSE(t.state.movables[1].resting);
  settle(t.state, t.world.model());
  EXPECT_NEAR(t.at(1).y, kRest, 1e-8);
  EXPECT_NEAR(t.at(2).y, kRest + kEdge, 1e-8);
  EXPECT_TRUE(t.state.movables[2].resting);
}

TEST(Blocks, LieFlatHoweverTheyWereLetGo) {
  OnTable t(1);
  t.drop(0, {0.0, kRest + 0.2, -0.6}, quaternion(TransformMatrix::rotation({1.0, 0.3, 0.5}, 0.9)));
  EXPECT_LT(lean(t.state.movables[0]), 1e-6);
  EXPECT_NEAR(t.at(0).y, kRest, 1e-8);
}

TEST(Blocks, LetGoInTheTableComeUpOrAside) {
  OnTable t(1);
  t.drop(0, {0.2, kTableTop + 0.01, -0.6});  // its centre is above the top: it belongs on it
  EXPECT_NEAR(t.at(0).y, kRest, 1e-8);
  EXPECT_NEAR(t.at(0).x, 0.2, 1e-9);
  t.drop(0, {0.71, kTableTop - 0.02, -0.6});  // it does not: it goes aside, and down
  EXPECT_NEAR(t.at(0).y, kEdge / 2, 1e-8);
  EXPECT_GT(t.at(0).x, 0.7 + kEdge / 2 - 1e-3);
}

TEST(Blocks, LetGoInAnotherMakeRoom) {
  OnTable t(2);
  const Coord3 other = t.at(1);
  t.drop(0, {other.x - 0.04, kRest, other.z + 0.003});
  EXPECT_NEAR(t.at(0).y, kRest, 1e-8);
  EXPECT_LT(t.at(0).x, other.x - kEdge + 1e-3);
  EXPECT_NEAR(norm(t.at(1) - other), 0.0, 1e-9) << "who was there first stays";
}

TEST(Blocks, SqueezedBetweenTwoGoOnTop) {
  OnTable t(3);
  t.drop(0, {-0.04, kRest, -0.6});
  t.drop(1, {0.04, kRest, -0.6});
  t.drop(2, {0.0, kRest, -0.6});
  EXPECT_NEAR(t.at(2).y, kRest + kEdge, 1e-8);
  EXPECT_TRUE(t.state.movables[2].resting);
}

constexpr std::uint32_t kWedged = 2'000'000;  // us of seeking, after which a movable stays as it is

/// No two stand in each other or in the table, each lies flat on something that carries it.
void expectSettled(const OnTable& t) {
  const std::size_t count = t.state.movables.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Movable& m = t.state.movables[i];
    RC_ASSERT(m.resting);
    RC_ASSERT(m.fall_um == 0);
    RC_ASSERT(lean(m) < 1e-6);
    const double steps = (t.at(i).y - kEdge / 2) / kEdge;
    const double table_steps = (t.at(i).y - kRest) / kEdge;
    const auto whole = [](double s) { return s > -1e-6 && std::abs(s - std::round(s)) < 1e-6; };
    RC_ASSERT(whole(steps) || whole(table_steps));  // on the floor, the table or another
    for (std::size_t k = i + 1; k < count && m.unrest_us < kWedged; ++k) {
      const Coord3 apart = t.at(i) - t.at(k);
      if (t.state.movables[k].unrest_us >= kWedged) continue;
      // Two cubes whose inner discs overlap stand in each other.
      if (std::abs(apart.y) < kEdge - 1e-3) RC_ASSERT(std::hypot(apart.x, apart.z) > kEdge - 1e-3);
    }
  }
}

RC_GTEST_PROP(Blocks, SettleWhereverTheyAreLetGo, ()) {
  OnTable t(4);
  for (int k = 0; k < 6; ++k) {
    const auto which = static_cast<std::size_t>(*rc::gen::inRange(0, 4));
    const Coord3 at{random::real(-0.12, 0.12), random::real(kTableTop + 0.002, kTableTop + 0.3),
                    random::real(-0.68, -0.52)};
    const int took = t.drop(which, at, quaternion(random::rotationMatrix()));
    RC_ASSERT(took < 4000);
    expectSettled(t);
  }
}

RC_GTEST_PROP(Blocks, SettleInAHeap, ()) {
  OnTable t(8);
  for (std::size_t i = 0; i < 8; ++i)
    t.state.movables[i] = letGo({random::real(-0.06, 0.06), random::real(kTableTop + 0.002, kTableTop + 0.4),
                                 random::real(-0.66, -0.54)},
                                quaternion(random::rotationMatrix()));
  RC_ASSERT(settle(t.state, t.world.model(), 10'000) < 10'000);
  expectSettled(t);
}

RC_GTEST_PROP(Blocks, WhatRestsIsNeverMovedAgain, ()) {
  OnTable t(4);
  for (std::size_t i = 0; i < 4; ++i)
    t.drop(i, {random::real(-0.1, 0.1), random::real(kTableTop, kTableTop + 0.3), random::real(-0.66, -0.54)},
           quaternion(random::rotationMatrix()));
  const WorldState before = t.state;
  wakeUnsupported(t.state, t.world.model());
  for (int i = 0; i < 100; ++i) stepBlocks(t.state, t.world.model(), kMillisecond);
  RC_ASSERT(t.state == before);
}

TEST(Blocks, AreSteppedAlikeFarFromTheOrigin) {
  const WorldModel near = tableWorld(2);
  WorldModel far = near;
  const std::int64_t away = 900'000'000'000'000'000;
  for (SolidBox& box : far.solids) box.centre.x_nm += away;
  for (MovableModel& m : far.movables) m.start.x_nm += away;
  const auto fallen = [&](const WorldModel& model, std::int64_t shift) {
    const World world(model);
    WorldState state = world.initialState();
    state.movables[0] = letGo({0.03, 1.0, -0.6}, quaternion(TransformMatrix::rotation({1.0, 2.0, 0.5}, 1.1)));
    state.movables[0].x_nm += shift;
    settle(state, world.model());
    for (Movable& m : state.movables) m.x_nm -= shift;
    return state.movables;
  };
  EXPECT_EQ(fallen(near, 0), fallen(far, away)) << "to the last bit";
}

TEST(Towers, AreThreeUponEachOther) {
  OnTable t(4);
  const Coord3 base = t.at(0);
  EXPECT_FALSE(towerStands(t.state, t.world.model()));
  t.drop(2, base + Coord3{0.0, kEdge + 0.01, 0.0});
  EXPECT_FALSE(towerStands(t.state, t.world.model())) << "two are none";
  t.drop(3, base + Coord3{0.0, 2 * kEdge + 0.01, 0.0});
  EXPECT_TRUE(towerStands(t.state, t.world.model()));
  t.state.movables[3].holder = Holder::OperatorHand;
  t.state.movables[3].resting = false;
  EXPECT_FALSE(towerStands(t.state, t.world.model())) << "what a hand holds is not built";
}

}  // namespace
}  // namespace coherency
