#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/motion/CompactCode.h"
#include "common/wire/Validity.h"
#include "motion_server/authority/Foresight.h"
#include "tests/world/Support.h"

namespace coherency {
namespace {

using worlds::kMillisecond;

/// What the master gives at a millisecond: a nodding driver who pushes the stick ahead.
MotionSample sampleAt(std::int64_t ms) {
  MotionSample sample = worlds::driving({.y = 1.0});
  sample.sequence = static_cast<std::uint64_t>(ms);
  sample.server_time_ns = ms * kMillisecond;
  sample.device_time_us = ms * 1000;
  sample.units[index(Dof::HeadPitch)] =
      unitsFromSi(DofKind::Angle, 0.3 * std::sin(static_cast<double>(ms) * 6e-3));
  return sample;
}

/// A world that is stepped each millisecond, and what is foreseen of it.
struct Driven {
  explicit Driven(const ForesightConfig& config, const WorldModel& model = worlds::plane())
      : compact(config.compact), world(model), foresight(config, world), state(world.initialState()) {}

  void pass(int ms) {
    for (int i = 0; i < ms; ++i) {
      newest = sampleAt(++now_ms);
      if (compact) newest = compacted(newest);
      world.step(state, newest, kMillisecond);
      foresight.add(newest);
    }
  }
  FrameState frameSeenIn(std::int64_t ns) {
    return foresight.frame(++frames, state, {newest.server_time_ns + ns});
  }

  bool compact;
  World world;
  Foresight foresight;
  WorldState state;
  MotionSample newest;
  std::int64_t now_ms = 0;
  std::uint64_t frames = 0;
};

ForesightConfig with(Prediction method, bool compact = false) {
  ForesightConfig config;
  config.prediction.method = method;
  config.compact = compact;
  return config;
}

TEST(Foresight, WithoutPredictionAFrameShowsTheStateItself) {
  Driven driven(with(Prediction::None));
  driven.pass(500);
  const FrameState frame = driven.frameSeenIn(40 * kMillisecond);
  EXPECT_EQ(frame.world, driven.state);
  EXPECT_EQ(frame.sample.units, driven.newest.units);
  EXPECT_EQ(frame.sample.sequence, driven.newest.sequence);
  EXPECT_EQ(frame.photons(), ServerTime{540 * kMillisecond});
  EXPECT_TRUE(hashHolds(frame));
}

TEST(Foresight, AFrameThatIsSeenAtOnceShowsTheStateItself) {
  for (const Prediction method : {Prediction::None, Prediction::Velocity, Prediction::Kalman}) {
    Driven driven(with(method));
    driven.pass(500);
    const FrameState frame = driven.frameSeenIn(0);
    EXPECT_EQ(frame.world, driven.state);
    EXPECT_EQ(frame.sample.units, driven.newest.units);
    EXPECT_EQ(driven.frameSeenIn(-5 * kMillisecond).world, driven.state) << "nor is the past foreseen";
  }
}

TEST(Foresight, TheWorldIsSteppedOnWithTheSampleThatIsShown) {
  for (const bool compact : {false, true}) {
    for (const Prediction method : {Prediction::Velocity, Prediction::Kalman}) {
      Driven driven(with(method, compact));
      driven.pass(500);
      for (const std::int64_t ms : {1, 16, 37}) {
        const FrameState frame = driven.frameSeenIn(ms * kMillisecond + 999'999);
        WorldState stepped = driven.state;
        worlds::run(driven.world, stepped, frame.sample, static_cast<int>(ms));
        EXPECT_EQ(frame.world, stepped) << ms;
        EXPECT_EQ(frame.world.tick, driven.state.tick + static_cast<std::uint64_t>(ms));
        EXPECT_TRUE(hashHolds(frame));
        EXPECT_TRUE(isValid(frame));
        EXPECT_EQ(frame.sample.device_time_us, 0) << "no device has said so";
        EXPECT_NE(frame.sample.units[index(Dof::HeadPitch)], driven.newest.units[index(Dof::HeadPitch)]);
        EXPECT_EQ(frame.sample.units[index(Dof::StickY)], driven.newest.units[index(Dof::StickY)]);
      }
    }
  }
}

TEST(Foresight, NothingIsForeseenFartherThanTheHorizon) {
  ForesightConfig config = with(Prediction::Kalman);
  config.prediction.max_horizon_ms = 20.0;
  Driven driven(config), same(config);
  driven.pass(500);
  same.pass(500);
  FrameState far = driven.frameSeenIn(90 * kMillisecond);
  const FrameState near = same.frameSeenIn(20 * kMillisecond);
  EXPECT_EQ(far.world, near.world);
  EXPECT_EQ(far.world.tick, driven.state.tick + 20);
  EXPECT_EQ(far.photons(), ServerTime{590 * kMillisecond}) << "it is seen then all the same";
  EXPECT_EQ(far.sample.units, near.sample.units);
}

TEST(Foresight, WhatIsForeseenCanBeToldInTheCompactEncoding) {
  Driven driven(with(Prediction::Kalman, true));
  for (int i = 0; i < 50; ++i) {
    driven.pass(16);
    const FrameState frame = driven.frameSeenIn(30 * kMillisecond);
    EXPECT_EQ(frame.sample, compacted(frame.sample));
    EXPECT_TRUE(hashHolds(frame));
  }
}

TEST(Foresight, WhoDrivesIsSeenWhereHeWillBe) {
  Driven driven(with(Prediction::Kalman));
  driven.pass(1000);
  const FrameState frame = driven.frameSeenIn(50 * kMillisecond);
  driven.pass(50);
  EXPECT_EQ(frame.world.master, driven.state.master) << "the stick was held, and the rules are the same";
}

TEST(Foresight, WhoDrivesTowardsAWallIsNeverSeenInIt) {
  constexpr double kWallFace = -1.0, kRadius = 0.4;
  WorldModel model = worlds::plane();
  model.solids = {worlds::box(0.0, kWallFace - 0.05, 4.0, 0.1, 0.0, 2.0)};
  Driven driven(with(Prediction::Kalman), model);
  const std::int64_t nearest_nm = nanometresFromMetres(kWallFace + kRadius) - 10;  // what rounding leaves
  bool carried_on_would_be = false;
  for (int i = 0; i < 150; ++i) {
    driven.pass(16);
    const FrameState frame = driven.frameSeenIn(60 * kMillisecond);
    EXPECT_GE(frame.world.master.base.z_nm, nearest_nm) << driven.now_ms;
    const std::int64_t straight_on =
        driven.state.master.base.z_nm - driven.state.master.velocity_ahead_um * std::int64_t{60};
    carried_on_would_be = carried_on_would_be || straight_on < nearest_nm - 1'000'000;
  }
  EXPECT_TRUE(carried_on_would_be) << "or there was nothing to be seen";
  EXPECT_LT(driven.state.master.base.z_nm, nearest_nm + 1'000'000) << "he has arrived at it";
}

TEST(Foresight, PredictionsAreScoredByWhatThenComes) {
  Driven driven(with(Prediction::Kalman));
  for (int i = 0; i < 100; ++i) {
    driven.pass(16);
    driven.frameSeenIn(15 * kMillisecond);
  }
  const DofScore score = driven.foresight.score().report(Dof::HeadPitch, horizonIndex(15 * kMillisecond));
  EXPECT_GE(score.count, 90U);
  EXPECT_LT(score.p95, score.held_p95);
}

}  // namespace
}  // namespace coherency
