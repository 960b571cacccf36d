#include "common/motion/DampedPredictor.h"

#include "common/motion/DofMotion.h"

namespace coherency {

DampedPredictor::DampedPredictor(const PredictorConfig& config)
    : predictor_(makePredictor(config)), score_(std::make_unique<PredictionScore>()) {}

void DampedPredictor::add(const MotionSample& sample) {
  predictor_->add(sample);
  score_->arrived(sample);
}

MotionSample DampedPredictor::predictFor(std::int64_t time_ns) {
  const MotionSample& base = predictor_->newest();
  const std::int64_t horizon_ns = predictor_->horizonTo(time_ns);
  const MotionSample raw = predictor_->predict(horizon_ns);
  const std::size_t horizon = horizonIndex(horizon_ns);
  MotionSample given = raw;
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const Dof dof = dofAt(i);
    if (raw.units[i] == base.units[i]) continue;
    given.units[i] = moved(dof, base.units[i],
                           score_->gain(dof, horizon) * displacement(dof, base.units[i], raw.units[i]));
  }
  score_->predicted(base, raw, given, horizon_ns);
  return given;
}

}  // namespace coherency
