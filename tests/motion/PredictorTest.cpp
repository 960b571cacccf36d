#include <array>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/motion/Predictor.h"
#include "tests/math/Random.h"
#include "tests/motion/Motions.h"

namespace coherency {
namespace {

constexpr std::array<Prediction, 3> kAll = {Prediction::None, Prediction::Velocity, Prediction::Kalman};
constexpr std::array<Prediction, 2> kMoving = {Prediction::Velocity, Prediction::Kalman};
constexpr std::int64_t kMs = 1'000'000;

using Motion = std::function<double(Dof, double)>;

/// Fed with `ms` milliseconds of a motion.
std::unique_ptr<Predictor> fed(Prediction method, const Motion& si, std::int64_t ms) {
  auto predictor = makePredictor({method, 80.0});
  for (std::int64_t t = 0; t <= ms; ++t) predictor->add(sampleOf(si, t));
  return predictor;
}

/// Each DOF from the middle of its range at a speed of its own, half of the range in a second at most.
double steady(Dof dof, double t) {
  const DofInfo& d = info(dof);
  const double speed = 0.025 * static_cast<double>(index(dof) + 1) * (index(dof) % 2 == 0 ? 1.0 : -1.0);
  return 0.5 * (d.min + d.max) + speed * 0.5 * (d.max - d.min) * t;
}

TEST(Prediction, NamesComeBack) {
  for (const Prediction method : kAll) EXPECT_EQ(predictionByName(predictionName(method)), method);
  EXPECT_EQ(predictionByName("kalmann"), std::nullopt);
  EXPECT_EQ(predictionByName(""), std::nullopt);
}

TEST(Predictor, WithoutASampleItSaysNothing) {
  for (const Prediction method : kAll) EXPECT_EQ(makePredictor({method, 80.0})->predict(kMs), MotionSample{});
}

TEST(Predictor, NoneHolds) {
  const auto predictor = fed(Prediction::None, steady, 100);
  EXPECT_EQ(predictor->predict(40 * kMs), predictor->newest());
}

TEST(Predictor, AtOnceItIsTheNewestSampleAndKeepsWhatIsNoUnit) {
  for (const Prediction method : kMoving) {
    const auto predictor = fed(method, steady, 100);
    EXPECT_EQ(predictor->predict(0), predictor->newest());
    EXPECT_EQ(predictor->predict(-5), predictor->newest());
    MotionSample moved_on = predictor->predict(40 * kMs);
    EXPECT_NE(moved_on, predictor->newest());
    moved_on.units = predictor->newest().units;
    EXPECT_EQ(moved_on, predictor->newest());
  }
}

/// To what a unit's rounding does to a velocity over the filter's few milliseconds.
TEST(Predictor, ConstantVelocityIsExact) {
  for (const Prediction method : kMoving) {
    const auto predictor = fed(method, steady, 200);
    for (const std::int64_t horizon : {10, 20, 40, 80}) {
      const MotionSample predicted = predictor->predict(horizon * kMs),
                         came = sampleOf(steady, 200 + horizon);
      for (std::size_t i = 0; i < kDofCount; ++i) {
        const Dof dof = dofAt(i);
        const MotionSample& expected = movesOn(dof) ? came : predictor->newest();
        EXPECT_NEAR(difference(dof, predicted, expected), 0.0, 25.0 * resolution(info(dof).kind))
            << predictionName(method) << " " << info(dof).name << " at " << horizon << " ms";
      }
    }
  }
}

/// A line through a window lags half of it behind an acceleration a, by a W / 2 in velocity: off by
/// a h^2 / 2 + a W h / 2. The filter knows of acceleration, and lags less.
TEST(Predictor, UnderConstantAccelerationTheFilterIsNearer) {
  constexpr double kAcceleration = 4.0;
  const Motion falling = [](Dof dof, double t) {
    return dof == Dof::HeadX ? -1.0 + 0.5 * kAcceleration * t * t : 0.0;
  };
  for (const std::int64_t horizon : {10, 20, 40}) {
    const double h = static_cast<double>(horizon) * 1e-3;
    const MotionSample came = sampleOf(falling, 300 + horizon);
    const auto off = [&](Prediction method) {
      return difference(Dof::HeadX, came, fed(method, falling, 300)->predict(horizon * kMs));
    };
    EXPECT_NEAR(off(Prediction::Velocity), 0.5 * kAcceleration * h * (h + 0.017), 5e-5);
    EXPECT_GT(off(Prediction::Kalman), 0.0);
    EXPECT_LT(off(Prediction::Kalman), 0.7 * off(Prediction::Velocity)) << horizon << " ms";
  }
}

TEST(Predictor, YawTurnsThrough180Degrees) {
  constexpr double kPi = std::numbers::pi;
  const Motion turning = [](Dof dof, double t) { return dof == Dof::HeadYaw ? kPi - 0.2 + 2.0 * t : 0.0; };
  for (const Prediction method : kMoving)
    for (const std::int64_t ms : {90, 99, 100, 101, 110}) {
      const MotionSample predicted = fed(method, turning, ms)->predict(40 * kMs);
      EXPECT_NEAR(difference(Dof::HeadYaw, predicted, sampleOf(turning, ms + 40)), 0.0, 1e-6) << ms;
    }
}

TEST(Predictor, NothingLeavesItsRange) {
  const Motion bending = [](Dof dof, double t) {
    return dof == Dof::ElbowFlexion ? std::min(2.8, 2.0 + 6.0 * t)
           : dof == Dof::Grip       ? std::max(0.0, 1.0 - 8.0 * t)
                                    : 0.0;
  };
  for (const Prediction method : kMoving) {
    const MotionSample predicted = fed(method, bending, 120)->predict(80 * kMs);
    EXPECT_NEAR(predicted.si(Dof::ElbowFlexion), 2.8, 1e-8);
    EXPECT_NEAR(predicted.si(Dof::Grip), 0.0, 1e-8);
  }
}

TEST(Predictor, TheHorizonIsCapped) {
  for (const Prediction method : kMoving) {
    const auto predictor = fed(method, steady, 100);
    EXPECT_EQ(predictor->predict(80 * kMs), predictor->predict(std::numeric_limits<std::int64_t>::max()));
    EXPECT_EQ(predictor->horizonTo(predictor->newest().server_time_ns + 30 * kMs), 30 * kMs);
    EXPECT_EQ(predictor->horizonTo(predictor->newest().server_time_ns + 90 * kMs), 80 * kMs);
    EXPECT_EQ(predictor->horizonTo(std::numeric_limits<std::int64_t>::min()), 0);
  }
}

TEST(Predictor, WhatIsNotValidIsHeldAndBeginsAnew) {
  for (const Prediction method : kMoving) {
    const auto predictor = fed(method, steady, 100);
    MotionSample blind = sampleOf(steady, 101);
    blind.valid &= ~mask(Dof::HeadX);
    predictor->add(blind);
    EXPECT_EQ(predictor->predict(40 * kMs).units[0], blind.units[0]);
    EXPECT_NE(predictor->predict(40 * kMs).units[1], blind.units[1]);
    // Seen again somewhere else: the leap is no velocity.
    MotionSample seen = sampleOf(steady, 102);
    seen.units[0] += 500'000;
    predictor->add(seen);
    EXPECT_EQ(predictor->predict(40 * kMs).units[0], seen.units[0]);
  }
}

TEST(Predictor, BeginsAnewAfterAGapOrARestart) {
  for (const Prediction method : kMoving) {
    for (const int what : {0, 1, 2}) {
      const auto predictor = fed(method, steady, 100);
      MotionSample next = sampleOf(steady, 101);
      if (what == 0) next.server_time_ns += kMotionGapNs;
      if (what == 1) next.sequence = 1;
      if (what == 2) next.server_time_ns -= kMs;
      predictor->add(next);
      EXPECT_EQ(predictor->predict(40 * kMs), next) << what;
    }
  }
}

/// The same motion at uneven intervals: as exact.
RC_GTEST_PROP(Predictor, UnevenIntervalsAreNoMotion, ()) {
  for (const Prediction method : kMoving) {
    const auto predictor = makePredictor({method, 80.0});
    std::int64_t ms = 0;
    for (int i = 0; i < 60; ++i) {
      ms += *rc::gen::inRange<std::int64_t>(1, 13);
      predictor->add(sampleOf(steady, ms));
    }
    const MotionSample predicted = predictor->predict(20 * kMs), came = sampleOf(steady, ms + 20);
    for (std::size_t i = 0; i <= index(Dof::Grip); ++i)
      RC_ASSERT(std::abs(difference(dofAt(i), predicted, came)) <= 25.0 * resolution(info(dofAt(i)).kind));
  }
}

/// Any integers at any times: no overflow, no number that is none, and what moves on stays in range.
RC_GTEST_PROP(Predictor, TakesAnything, ()) {
  for (const Prediction method : kMoving) {
    const auto predictor = makePredictor({method, 80.0});
    MotionSample sample;
    for (int i = 0; i < 40; ++i) {
      sample.sequence = *rc::gen::weightedOneOf<std::uint64_t>(
          {{9, rc::gen::just(sample.sequence + 1)}, {1, rc::gen::arbitrary<std::uint64_t>()}});
      const auto step = *rc::gen::weightedOneOf<std::uint64_t>(
          {{9, rc::gen::element<std::uint64_t>(1, 1'000'000, 100'000'000)},
           {1, rc::gen::arbitrary<std::uint64_t>()}});
      sample.server_time_ns =
          static_cast<std::int64_t>(static_cast<std::uint64_t>(sample.server_time_ns) + step);
      sample.valid = *rc::gen::weightedElement<DofMask>({{9, kAllDofs}, {1, 0x12345u}});
      for (auto& units : sample.units)
        units = *rc::gen::element(std::numeric_limits<std::int32_t>::min(),
                                  std::numeric_limits<std::int32_t>::max(), 0, 1'000'000, -7);
      predictor->add(sample);
      const MotionSample predicted = predictor->predict(80 * kMs);
      for (std::size_t d = 0; d < kDofCount; ++d) {
        const DofInfo& dof = dofTable()[d];
        if (predicted.units[d] == sample.units[d] || dof.kind == DofKind::Angle) continue;
        const double si = predicted.si(dofAt(d));
        RC_ASSERT(si >= dof.min - 1e-6 && si <= dof.max + 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace coherency
