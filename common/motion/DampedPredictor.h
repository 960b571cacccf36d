#pragma once

#include <memory>

#include "common/motion/PredictionScore.h"
#include "common/motion/Predictor.h"

namespace coherency {

/// A predictor that is scored by what then comes, and limited by it: each DOF goes only as far of the way
/// that was predicted as had been right of late (PredictionScore::gain), so that where prediction is worse
/// than holding it fades. One thread; allocates nothing after it was made.
class DampedPredictor {
 public:
  explicit DampedPredictor(const PredictorConfig& config);

  void add(const MotionSample& sample);
  /// The newest sample as it will be at server time `time_ns`; see Predictor::predict.
  MotionSample predictFor(std::int64_t time_ns);
  const PredictionScore& score() const { return *score_; }

 private:
  std::unique_ptr<Predictor> predictor_;
  std::unique_ptr<PredictionScore> score_;  // half a megabyte
};

}  // namespace coherency
