#include <algorithm>
#include <limits>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/motion/DampedPredictor.h"
#include "tests/motion/Motions.h"

namespace coherency {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(ErrorHistogram, QuantilesAreWithinABin) {
  ErrorHistogram histogram;
  EXPECT_EQ(histogram.quantile(0.5), 0.0);
  for (int i = 1; i <= 10000; ++i) histogram.add(i % 2 == 0 ? i : -i);
  EXPECT_EQ(histogram.count(), 10000u);
  for (const double q : {0.001, 0.01, 0.5, 0.95, 1.0}) {
    EXPECT_GE(histogram.quantile(q), 10000.0 * q);
    EXPECT_LE(histogram.quantile(q), 10000.0 * q * 1.0625);
  }
}

TEST(ErrorHistogram, TakesTheLargest) {
  ErrorHistogram histogram;
  histogram.add(std::numeric_limits<double>::infinity());
  EXPECT_EQ(histogram.quantile(0.5), 4294967295.0);
}

TEST(PredictionScore, HorizonsAreApart) {
  EXPECT_EQ(horizonIndex(0), 0u);
  EXPECT_EQ(horizonIndex(10 * kMs), 0u);
  EXPECT_EQ(horizonIndex(10 * kMs + 1), 1u);
  EXPECT_EQ(horizonIndex(40 * kMs), 2u);
  EXPECT_EQ(horizonIndex(80 * kMs), 3u);
}

MotionSample at(std::int64_t ms, std::int32_t um) {
  MotionSample sample = sampleOf([](Dof, double) { return 0.0; }, ms);
  sample.units[index(Dof::HeadX)] = um;
  return sample;
}

/// Three predictions by hand: what comes is 100 um a sample later, between two samples.
TEST(PredictionScore, ComparesWithWhatComesBetweenTwoSamples) {
  auto score = std::make_unique<PredictionScore>();
  score->arrived(at(0, 0));
  score->predicted(at(0, 0), at(0, 200), at(0, 130), 15 * kMs);
  score->arrived(at(10, 100));
  EXPECT_EQ(score->report(Dof::HeadX, 1).count, 0u);
  score->arrived(at(20, 200));  // 150 at 15 ms
  const DofScore once = score->report(Dof::HeadX, 1);
  EXPECT_EQ(once.count, 1u);
  EXPECT_NEAR(once.median, 20e-6, 1e-9);
  EXPECT_NEAR(once.held_median, 151e-6, 1e-9);  // a bin's upper edge
  EXPECT_NEAR(once.gain, 150.0 / 200.0, 1e-12);
  EXPECT_EQ(once.worse, 0.0);
  score->predicted(at(20, 200), at(20, 600), at(20, 600), 15 * kMs);
  score->arrived(at(35, 250));
  EXPECT_EQ(score->report(Dof::HeadX, 1).worse, 0.5);
  EXPECT_EQ(score->report(Dof::HeadX, 0).count, 0u);
  EXPECT_EQ(score->report(Dof::StickX, 1).count, 0u);
}

TEST(PredictionScore, GapsAndBlindDofsAreNotScored) {
  auto score = std::make_unique<PredictionScore>();
  score->arrived(at(0, 0));
  score->predicted(at(0, 0), at(0, 10), at(0, 10), 15 * kMs);
  score->arrived(at(200, 0));
  EXPECT_EQ(score->unscored(), 1u);
  score->predicted(at(200, 0), at(200, 10), at(200, 10), 15 * kMs);
  MotionSample blind = at(220, 0);
  blind.valid &= ~mask(Dof::HeadX);
  score->arrived(blind);
  EXPECT_EQ(score->report(Dof::HeadX, 1).count, 0u);
  EXPECT_EQ(score->report(Dof::HeadY, 1).count, 1u);
}

TEST(PredictionScore, MoreThanItsMemoryGoesUnscored) {
  auto score = std::make_unique<PredictionScore>();
  score->arrived(at(0, 0));
  for (std::size_t i = 0; i < PredictionScore::kPending + 3; ++i)
    score->predicted(at(0, 0), at(0, 1), at(0, 1), kMs);
  EXPECT_EQ(score->unscored(), 3u);
  score->arrived(at(1, 0));
  EXPECT_EQ(score->report(Dof::HeadX, 0).count, PredictionScore::kPending);
}

/// Random walks, scored and computed again from the list of all samples.
TEST(PredictionScore, EqualsAnIndependentComputation) {
  std::mt19937 random(7);
  std::vector<MotionSample> samples;
  std::int32_t x = 0;
  for (std::int64_t ms = 0; ms < 2000; ++ms)
    samples.push_back(at(ms, x += static_cast<int>(random() % 2001) - 1000));
  auto score = std::make_unique<PredictionScore>();
  std::vector<double> errors, held;
  double raw_raw = 0.0, raw_came = 0.0;
  for (std::size_t i = 0; i + 30 < samples.size(); ++i) {
    score->arrived(samples[i]);
    if (i % 7 != 0) continue;
    MotionSample raw = samples[i], given = samples[i];
    raw.units[0] += static_cast<int>(random() % 20001) - 10000;
    given.units[0] += static_cast<int>(random() % 20001) - 10000;
    score->predicted(samples[i], raw, given, 25 * kMs);
    if (i + 25 + 30 >= samples.size()) continue;
    const double came = samples[i + 25].units[0] - samples[i].units[0],
                 travel = raw.units[0] - samples[i].units[0];
    errors.push_back(std::abs(given.units[0] - samples[i + 25].units[0]));
    held.push_back(std::abs(came));
    const double kept = std::exp(-0.007 / PredictionScore::kMemoryS);
    const double weight = 1.0 / (std::abs(travel) + std::abs(came));
    raw_raw = kept * raw_raw + weight * travel * travel;
    raw_came = kept * raw_came + weight * travel * came;
  }
  std::sort(errors.begin(), errors.end());
  std::sort(held.begin(), held.end());
  const DofScore report = score->report(Dof::HeadX, 2);
  ASSERT_EQ(report.count, errors.size());
  const auto near = [](double binned, double exact) {
    return binned >= exact && binned <= exact * 1.0625 + 1.0;
  };
  const auto rank = [&](double q) {
    return static_cast<std::size_t>(std::ceil(q * static_cast<double>(errors.size()))) - 1;
  };
  EXPECT_TRUE(near(report.median * 1e6, errors[rank(0.5)])) << report.median;
  EXPECT_TRUE(near(report.p95 * 1e6, errors[rank(0.95)])) << report.p95;
  EXPECT_TRUE(near(report.held_median * 1e6, held[rank(0.5)])) << report.held_median;
  EXPECT_TRUE(near(report.held_p95 * 1e6, held[rank(0.95)])) << report.held_p95;
  EXPECT_NEAR(report.gain, std::clamp(raw_came / raw_raw, 0.0, 1.0), 1e-6);
}

/// The gain after ten seconds of a motion, and how far 40 ms of prediction were off beside holding.
DofScore after(const std::function<double(Dof, double)>& si) {
  DampedPredictor predictor({Prediction::Kalman, 80.0});
  for (std::int64_t ms = 0; ms < 10'000; ++ms) {
    const MotionSample sample = sampleOf(si, ms);
    predictor.add(sample);
    if (ms % 11 == 0) predictor.predictFor(sample.server_time_ns + 40 * kMs);
  }
  return predictor.score().report(Dof::HeadYaw, 2);
}

TEST(DampedPredictor, NoiseIsNotPredicted) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.01);
  const DofScore score = after([&](Dof, double) { return std::clamp(noise(random), -0.09, 0.09); });
  EXPECT_LT(score.gain, 0.05);
  EXPECT_LT(score.p95, 1.1 * score.held_p95);
}

TEST(DampedPredictor, SmoothMotionIs) {
  const DofScore score = after([](Dof, double t) { return 0.09 * std::sin(3.0 * t); });
  EXPECT_GT(score.gain, 0.97);
  EXPECT_LT(score.p95, 0.1 * score.held_p95);
  EXPECT_LT(score.worse, 0.06);  // where it turns
}

/// To and fro in 100 ms, of which 40 ms are too long a way to look ahead.
TEST(DampedPredictor, WhatOvershootsIsDamped) {
  const DofScore score = after([](Dof, double t) { return 0.05 * std::sin(62.8 * t); });
  EXPECT_LT(score.gain, 0.5);
  EXPECT_LT(score.p95, 1.05 * score.held_p95);
}

TEST(DampedPredictor, BeforeASampleItSaysNothing) {
  DampedPredictor predictor({});
  EXPECT_EQ(predictor.predictFor(123), MotionSample{});
  EXPECT_EQ(predictor.score().report(Dof::HeadX, 0).count, 0u);
  EXPECT_EQ(predictor.score().gain(Dof::HeadX, 0), 1.0);
}

}  // namespace
}  // namespace coherency
