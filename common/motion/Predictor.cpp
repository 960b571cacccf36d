#include "common/motion/Predictor.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "common/motion/DofMotion.h"
#include "common/motion/KalmanPredictor.h"
#include "common/motion/VelocityPredictor.h"

namespace coherency {

namespace {

constexpr std::array<std::string_view, 3> kNames = {"none", "velocity", "kalman"};

class HoldingPredictor final : public Predictor {
 public:
  using Predictor::Predictor;

 private:
  void observe(const MotionSample& /*sample*/, double /*interval_s*/) override {}
  double travel(Dof /*dof*/, double /*horizon_s*/) const override { return 0.0; }
};

}  // namespace

std::string_view predictionName(Prediction prediction) {
  return kNames[static_cast<std::size_t>(prediction)];
}

std::optional<Prediction> predictionByName(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Prediction>(found - kNames.begin());
}

Predictor::Predictor(double max_horizon_ms) : max_horizon_ns_(std::llround(max_horizon_ms * 1e6)) {
  assert(max_horizon_ms >= 0.0);
}

void Predictor::add(const MotionSample& sample) {
  observe(sample, intervalSeconds(newest_, sample));
  newest_ = sample;
}

std::int64_t Predictor::horizonTo(std::int64_t time_ns) const {
  if (time_ns <= newest_.server_time_ns) return 0;
  const std::uint64_t horizon_ns =
      static_cast<std::uint64_t>(time_ns) - static_cast<std::uint64_t>(newest_.server_time_ns);
  return static_cast<std::int64_t>(std::min(horizon_ns, static_cast<std::uint64_t>(max_horizon_ns_)));
}

MotionSample Predictor::predict(std::int64_t horizon_ns) const {
  const double horizon_s =
      static_cast<double>(std::clamp<std::int64_t>(horizon_ns, 0, max_horizon_ns_)) * 1e-9;
  MotionSample predicted = newest_;
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const Dof dof = dofAt(i);
    if (!movesOn(dof) || !newest_.isValid(dof)) continue;
    const double by = travel(dof, horizon_s);
    if (by != 0.0) predicted.units[i] = moved(dof, newest_.units[i], by);
  }
  return predicted;
}

std::unique_ptr<Predictor> makePredictor(const PredictorConfig& config) {
  switch (config.method) {
    case Prediction::None:
      return std::make_unique<HoldingPredictor>(config.max_horizon_ms);
    case Prediction::Velocity:
      return std::make_unique<VelocityPredictor>(config.max_horizon_ms);
    case Prediction::Kalman:
      return std::make_unique<KalmanPredictor>(config.max_horizon_ms);
  }
  assert(false);
  return nullptr;
}

}  // namespace coherency
