#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "common/motion/MotionSample.h"
#include "common/motion/Predictor.h"
#include "motion_server/device/Recording.h"

namespace coherency {

/// How a recording becomes samples: its rows as they are, or every millisecond, as the server plays it.
enum class Sampled { Rows, EveryMillisecond };
std::vector<MotionSample> samplesOf(const Recording& recording, Sampled sampled);

/// Errors as a person perceives them: of the head's position in mm, of its attitude in degrees, of each arm
/// joint in degrees.
enum class ErrorGroup : std::uint8_t { HeadPosition, HeadRotation, ArmJoint };
inline constexpr std::size_t kErrorGroups = 3;
inline constexpr std::array<std::string_view, kErrorGroups> kErrorGroupNames = {"head, mm", "head, deg",
                                                                                "arm, deg"};

struct PredictionErrors {
  std::array<std::vector<double>, kErrorGroups> off;  ///< one number a prediction (and joint), unsorted
  std::array<std::size_t, kErrorGroups> worse{};      ///< farther from what came than holding was

  void append(const PredictionErrors& other);
  double quantile(ErrorGroup group, double q) const;  ///< nearest rank; 0 of nothing
  double worseShare(ErrorGroup group) const;
};

/// Predicts every eighth millisecond or so by `horizon_ms` and compares with the samples about that time.
/// `damped`: as DampedPredictor gives it.
PredictionErrors predictionErrors(const std::vector<MotionSample>& samples, Prediction method, bool damped,
                                  double horizon_ms);

}  // namespace coherency
