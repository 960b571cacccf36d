#include <filesystem>

#include <gtest/gtest.h>

#include "bench/PredictionErrors.h"

namespace coherency {
namespace {

/// Real people, sampled as the server samples them; those that the filter's figures were not chosen on.
class RecordedMotion : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::string file = std::string(COHERENCY_MOTION_DATA) + "/" + GetParam() + ".csv";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no recording " << file;
    samples_ = samplesOf(readRecording(file), Sampled::EveryMillisecond);
  }
  std::vector<MotionSample> samples_;
};

TEST_P(RecordedMotion, PredictionIsNearerThanHoldingForTheHead) {
  for (const double horizon_ms : {10.0, 20.0, 40.0}) {
    const PredictionErrors held = predictionErrors(samples_, Prediction::None, false, horizon_ms);
    for (const bool damped : {false, true}) {
      const PredictionErrors predicted = predictionErrors(samples_, Prediction::Kalman, damped, horizon_ms);
      for (const ErrorGroup group : {ErrorGroup::HeadPosition, ErrorGroup::HeadRotation})
        for (const double q : {0.5, 0.95})
          EXPECT_LT(predicted.quantile(group, q), 0.8 * held.quantile(group, q))
              << horizon_ms << " ms, " << q;
    }
  }
}

TEST_P(RecordedMotion, DampedPredictionIsNotWorseThanHoldingAt80Ms) {
  const PredictionErrors held = predictionErrors(samples_, Prediction::None, false, 80.0);
  const PredictionErrors damped = predictionErrors(samples_, Prediction::Kalman, true, 80.0);
  for (std::size_t g = 0; g < kErrorGroups; ++g)
    for (const double q : {0.5, 0.95}) {
      const auto group = static_cast<ErrorGroup>(g);
      EXPECT_LE(damped.quantile(group, q), 1.03 * held.quantile(group, q))
          << kErrorGroupNames[g] << ", " << q;
    }
}

INSTANTIATE_TEST_SUITE_P(People, RecordedMotion,
                         ::testing::Values("cmu_02_10_wash_self", "cmu_14_20_reach_twist_bend",
                                           "hmd_quest_optitrack"),
                         [](const auto& recording) { return std::string(recording.param); });

}  // namespace
}  // namespace coherency
