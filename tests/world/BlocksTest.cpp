#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/world/Blocks.h"
#include "common/world/Neighbourhood.h"
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

/// Sideways, beyond what is let be; in a heap that has found no better rest within its patience.
constexpr double kOverlap = 1e-3;
constexpr double kWedgedOverlap = 0.020;

/// How far number `which` stands in others and in solids, sideways; m.
double standsIn(const OnTable& t, std::size_t which) {
  const Cube cube(t.state.movables[which], kEdge);
  double depth = 0.0;
  for (std::size_t k = 0; k < t.state.movables.size(); ++k) {
    const Cube other(t.state.movables[k], kEdge);
    if (k == which || std::abs(cube.above(other.place())) > kEdge - 1e-3) continue;
    depth =
        std::max(depth, rectangleInRectangle(cube.square(cube.place()), other.square(cube.place())).depth);
  }
  return depth;
}

/// Each lies flat, touches a top below it, has its centre over what carries it, and stands in nothing. Only
/// what is wedged may hang over and overlap a little: then it touches something beside it.
void expectSettled(const OnTable& t) {
  for (std::size_t i = 0; i < t.state.movables.size(); ++i) {
    const Movable& m = t.state.movables[i];
    RC_ASSERT(m.resting);
    RC_ASSERT(m.fall_um == 0);
    RC_ASSERT(lean(m) < 1e-6);
    const bool wedged = m.unrest_us == kPatienceUs;
    const Neighbourhood around(t.state, t.world.model(), i);
    const Support support = around.support();
    RC_ASSERT(std::abs(-support.top - around.cube().lowest()) < kSameHeight);  // neither in the air nor sunk
    const bool carried = support.area.empty() || length(nearestToOrigin(support.area)) < 6e-4;
    RC_ASSERT(carried || wedged);
    bool beside_wedged = wedged;
    for (const Movable& other : t.state.movables) beside_wedged |= other.unrest_us == kPatienceUs;
    RC_ASSERT(standsIn(t, i) < (beside_wedged ? kWedgedOverlap : kOverlap));
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

RC_GTEST_PROP(Blocks, WhatHungInAHeapFallsWhenTheHeapIsTaken, ()) {
  OnTable t(8);
  for (std::size_t i = 0; i < 8; ++i)
    t.state.movables[i] = letGo({random::real(-0.08, 0.08), random::real(kTableTop + 0.03, kTableTop + 0.3),
                                 random::real(-0.66, -0.50)},
                                quaternion(random::rotationMatrix()));
  settle(t.state, t.world.model(), 10'000);
  // All but one are taken, one by one.
  const auto left = static_cast<std::size_t>(*rc::gen::inRange(0, 8));
  for (std::size_t i = 0; i < 8; ++i) {
    if (i == left) continue;
    t.state.movables[i].holder = Holder::OperatorHand;
    wakeUnsupported(t.state, t.world.model());
    settle(t.state, t.world.model(), 10'000);
  }
  RC_ASSERT(t.state.movables[left].resting);
  RC_ASSERT(t.state.movables[left].unrest_us == 0U);
  const double y = t.at(left).y;
  RC_ASSERT(std::abs(y - kRest) < 1e-6 || std::abs(y - kEdge / 2) < 1e-6);
}

RC_GTEST_PROP(Blocks, WhatRestsIsNeverMovedAgain, ()) {
  OnTable t(4);
  for (std::size_t i = 0; i < 4; ++i)
    t.drop(i, {random::real(-0.1, 0.1), random::real(kTableTop, kTableTop + 0.3), random::real(-0.66, -0.54)},
           quaternion(random::rotationMatrix()));
  for (const Movable& m : t.state.movables) RC_PRE(m.unrest_us == 0U);  // what is wedged tries again
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
