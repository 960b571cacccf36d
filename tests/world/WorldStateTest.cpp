#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/FixedPoint.h"
#include "common/world/WorldState.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

struct Controls {
  double x = 0, y = 0, twist = 0, brake = 0, boost = 0;
};

MotionSample driving(const Controls& c) {
  MotionSample sample;
  sample.valid = kAllDofs;
  sample.units[index(Dof::StickX)] = unitsFromRatio(c.x);
  sample.units[index(Dof::StickY)] = unitsFromRatio(c.y);
  sample.units[index(Dof::StickTwist)] = unitsFromRatio(c.twist);
  sample.units[index(Dof::PedalLeft)] = unitsFromRatio(c.brake);
  sample.units[index(Dof::PedalRight)] = unitsFromRatio(c.boost);
  return sample;
}

double speed(const WorldState& s) {
  return std::hypot(s.velocity_right_um, s.velocity_ahead_um) * 1e-6;
}

MotionSample anyDriving() {
  return driving({random::real(-1, 1), random::real(-1, 1), random::real(-1, 1), random::real(0, 1),
                  random::real(0, 1)});
}

TEST(Step, AMillionStepsAheadEndWhereIntegersSay) {
  WorldState state;
  const MotionSample ahead = driving({.y = 1.0});
  const DriveLimits limits{.speed = 0.8, .acceleration = 1.5};
  for (int i = 0; i < 1'000'000; ++i) step(state, ahead, kMillisecond, limits, {});
  // 1500 um/s more each step up to 800000: 533 steps of rising speed, then the full one; one um/s is one nm a
  // ms.
  std::int64_t expected = 0;
  for (std::int64_t i = 1; i <= 1'000'000; ++i) expected += std::min<std::int64_t>(1500 * i, 800'000);
  EXPECT_EQ(state.base.z_nm, -expected);
  EXPECT_EQ(state.base.x_nm, 0);
  EXPECT_EQ(state.base.heading_units, 0);
  EXPECT_EQ(state.tick, 1'000'000u);
}

TEST(Step, HeadingWrapsExactly) {
  WorldState state;
  const MotionSample turning = driving({.twist = 1.0});
  for (int i = 0; i < 2000; ++i) step(state, turning, kMillisecond, {}, {});
  const std::int64_t each = std::llround(state.turn_rate_units * 1e-3);
  const auto begin = static_cast<std::uint32_t>(state.base.heading_units);
  for (int i = 0; i < 100'000; ++i) step(state, turning, kMillisecond, {}, {});
  EXPECT_EQ(static_cast<std::uint32_t>(state.base.heading_units),
            begin + static_cast<std::uint32_t>(100'000 * each));  // modulo 2^32: a dozen turns
}

TEST(Step, DirectionsAreAsDocumented) {
  const auto after = [](const Controls& c, double heading) {
    WorldState state;
    state.base.heading_units = unitsFromRadians(heading);
    for (int i = 0; i < 1000; ++i) step(state, driving(c), kMillisecond, {}, {});
    return state.base;
  };
  EXPECT_LT(after({.y = 1}, 0).z_nm, -300'000'000);
  EXPECT_GT(after({.x = 1}, 0).x_nm, 300'000'000);
  EXPECT_GT(after({.twist = 1}, 0).heading_units, 0);
  EXPECT_LT(after({.y = 1}, kTurn / 4).x_nm, -300'000'000) << "turned left, ahead is -x";
  EXPECT_NEAR(static_cast<double>(after({.y = 1}, kTurn / 4).z_nm), 0.0, 1000.0);
  const Coord3 ahead = transform(after({}, 0.3)).vector({0, 0, -1});
  EXPECT_NEAR(ahead.x, -std::sin(0.3), 1e-9);
}

RC_GTEST_PROP(Step, NeverLeavesTheAreaNorExceedsItsLimits, ()) {
  const DriveArea area{-1.0, 1.5, -2.0, 0.5};
  const DriveLimits limits;
  WorldState state;
  state.base.heading_units = *rc::gen::arbitrary<std::int32_t>();
  for (int stretch = 0; stretch < 6; ++stretch) {
    const MotionSample sample = anyDriving();
    for (int i = 0; i < 1000; ++i) {
      const WorldState before = state;
      step(state, sample, kMillisecond, limits, area);
      RC_ASSERT(state.base.x_nm >= -1'000'000'000 && state.base.x_nm <= 1'500'000'000);
      RC_ASSERT(state.base.z_nm >= -2'000'000'000 && state.base.z_nm <= 500'000'000);
      RC_ASSERT(speed(state) <= limits.speed * limits.boost + 1e-5);
      RC_ASSERT(std::abs(state.turn_rate_units * kAngleUnit) <= limits.turn_rate + 1e-6);
      RC_ASSERT(std::abs(state.turn_rate_units - before.turn_rate_units) * kAngleUnit <=
                limits.turn_acceleration * 1e-3 + 1e-9);
      const double moved = std::hypot(static_cast<double>(state.base.x_nm - before.base.x_nm),
                                      static_cast<double>(state.base.z_nm - before.base.z_nm));
      RC_ASSERT(moved <= (limits.speed * limits.boost) * 1e6 + 2.0);
    }
  }
}

RC_GTEST_PROP(Step, AcceleratesWithinItsLimit, ()) {
  const DriveLimits limits;
  WorldState state;
  state.velocity_ahead_um = *rc::gen::inRange(-1'000'000, 1'000'000);
  state.velocity_right_um = *rc::gen::inRange(-1'000'000, 1'000'000);
  const WorldState before = state;
  const MotionSample sample = anyDriving();
  step(state, sample, kMillisecond, limits, {});
  const double change = std::hypot(state.velocity_ahead_um - before.velocity_ahead_um,
                                   state.velocity_right_um - before.velocity_right_um) *
                        1e-6;
  const double brake = sample.si(Dof::PedalLeft);
  RC_ASSERT(change <= (limits.acceleration + brake * (limits.brake - limits.acceleration)) * 1e-3 + 1.5e-6);
}

double metresToStop(double brake, DofMask valid) {
  WorldState state;
  for (int i = 0; i < 2000; ++i) step(state, driving({.y = 1.0}), kMillisecond, {}, {});
  const std::int64_t from = state.base.z_nm;
  MotionSample sample = driving({.y = brake > 0 ? 0.0 : 1.0, .brake = brake});
  sample.valid = valid;
  for (int i = 0; i < 5000 && speed(state) > 0.0; ++i) step(state, sample, kMillisecond, {}, {});
  EXPECT_EQ(speed(state), 0.0);
  return static_cast<double>(from - state.base.z_nm) * 1e-9;
}

TEST(Step, BrakesAndComesToRestWithoutAStick) {
  const double with_brake = metresToStop(1.0, kAllDofs);
  const double stick_lost = metresToStop(0.0, kAllDofs & ~mask(Dof::StickY));
  EXPECT_NEAR(with_brake, 0.8 * 0.8 / (2 * 6.0), 0.005);  // v^2 / 2a
  EXPECT_NEAR(stick_lost, 0.8 * 0.8 / (2 * 1.5), 0.005);
}

TEST(Step, SlidesAlongABorder) {
  WorldState state;
  state.base.heading_units = unitsFromRadians(kTurn / 8);
  const DriveArea area{-0.5, 10.0, -100.0, 100.0};
  for (int i = 0; i < 10'000; ++i) step(state, driving({.y = 1.0}), kMillisecond, {}, area);
  EXPECT_EQ(state.base.x_nm, -500'000'000);
  const std::int64_t before = state.base.z_nm;
  for (int i = 0; i < 1000; ++i) step(state, driving({.y = 1.0}), kMillisecond, {}, area);
  EXPECT_LT(state.base.z_nm, before - 300'000'000);
}

TEST(Step, FromOutsideTheAreaOneOnlyComesIn) {
  const DriveArea area{-1.0, 1.0, -1.0, 1.0};
  WorldState out;
  out.base.x_nm = 3'000'000'000;
  WorldState in = out;
  for (int i = 0; i < 1000; ++i) {
    step(out, driving({.x = 1.0}), kMillisecond, {}, area);
    const std::int64_t before = in.base.x_nm;
    step(in, driving({.x = -1.0}), kMillisecond, {}, area);
    ASSERT_LE(std::abs(in.base.x_nm - before), 800'000) << "no jump";
  }
  EXPECT_EQ(out.base.x_nm, 3'000'000'000);
  EXPECT_LT(in.base.x_nm, 2'600'000'000);
}

TEST(StateHash, KnownValue) {
  // FNV-1a over 152 zero bytes: 8 + 24 + 4 + 12 of the state, 24 + 4 + 76 of the sample.
  std::uint64_t expected = 0xCBF29CE484222325U;
  for (int i = 0; i < 152; ++i) expected *= 0x100000001B3U;
  EXPECT_EQ(stateHash({}, {}), expected);
}

RC_GTEST_PROP(StateHash, ChangesWithEveryField, ()) {
  WorldState s;
  MotionSample m;
  for (std::int32_t& units : m.units) units = *rc::gen::arbitrary<std::int32_t>();
  s.tick = *rc::gen::arbitrary<std::uint64_t>();
  s.base.x_nm = *rc::gen::arbitrary<std::int64_t>();
  const std::uint64_t before = stateHash(s, m);
  const auto bit = *rc::gen::inRange(0, 19);
  const std::vector<std::function<void(WorldState&, MotionSample&)>> changes = {
      [&](auto& w, auto&) { w.tick ^= std::uint64_t{1} << bit; },
      [&](auto& w, auto&) { w.base.x_nm ^= std::int64_t{1} << bit; },
      [&](auto& w, auto&) { w.base.y_nm ^= std::int64_t{1} << bit; },
      [&](auto& w, auto&) { w.base.z_nm ^= std::int64_t{1} << bit; },
      [&](auto& w, auto&) { w.base.heading_units ^= 1 << bit; },
      [&](auto& w, auto&) { w.velocity_right_um ^= 1 << bit; },
      [&](auto& w, auto&) { w.velocity_ahead_um ^= 1 << bit; },
      [&](auto& w, auto&) { w.turn_rate_units ^= 1 << bit; },
      [&](auto&, auto& x) { x.sequence ^= std::uint64_t{1} << bit; },
      [&](auto&, auto& x) { x.server_time_ns ^= std::int64_t{1} << bit; },
      [&](auto&, auto& x) { x.device_time_us ^= std::int64_t{1} << bit; },
      [&](auto&, auto& x) { x.valid ^= DofMask{1} << bit; },
  };
  std::set<std::uint64_t> seen = {before};
  for (const auto& change : changes) {
    WorldState other = s;
    MotionSample sample = m;
    change(other, sample);
    RC_ASSERT(seen.insert(stateHash(other, sample)).second);
  }
  for (std::size_t i = 0; i < kDofCount; ++i) {
    MotionSample sample = m;
    sample.units[i] ^= 1 << bit;
    RC_ASSERT(seen.insert(stateHash(s, sample)).second);
  }
}

}  // namespace
}  // namespace coherency
