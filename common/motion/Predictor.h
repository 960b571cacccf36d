#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "common/motion/MotionSample.h"

namespace coherency {

/// How the 19 DOFs are carried on to the time at which they are seen.
enum class Prediction : std::uint8_t {
  None,      ///< the newest sample is held
  Velocity,  ///< at the velocity of the last milliseconds (VelocityPredictor)
  Kalman,    ///< by a filter of position, velocity and acceleration (KalmanPredictor)
};
std::string_view predictionName(Prediction prediction);  ///< "none", "velocity", "kalman"
std::optional<Prediction> predictionByName(std::string_view name);

struct PredictorConfig {
  Prediction method = Prediction::Kalman;
  double max_horizon_ms = 80.0;  ///< nobody is predicted farther than this; >= 0
};

/// Predicts each DOF by itself from the samples it is fed, at any even or uneven rate. Held as they are:
/// stick and pedals (commands), DOFs whose newest value is not valid, and all after a sample with which
/// motion begins anew (intervalSeconds() in DofMotion.h). Takes any integers; allocates nothing after it was
/// made.
class Predictor {
 public:
  explicit Predictor(double max_horizon_ms);
  virtual ~Predictor() = default;

  void add(const MotionSample& sample);
  /// The newest sample with its units moved on by `horizon_ns` (0 to max_horizon_ms, else the nearer of
  /// them), within the DOFs' ranges; its sequence, times and validity are kept. Before a first sample
  /// MotionSample{}.
  MotionSample predict(std::int64_t horizon_ns) const;
  /// From the newest sample to a server time, as predict() would have it: 0 to max_horizon_ms.
  std::int64_t horizonTo(std::int64_t time_ns) const;
  const MotionSample& newest() const { return newest_; }

 protected:
  /// A sample `interval_s` after the one before; 0: motion begins anew with it.
  virtual void observe(const MotionSample& sample, double interval_s) = 0;
  /// How far, in its units, a valid DOF that moves on goes from the newest sample. Finite.
  virtual double travel(Dof dof, double horizon_s) const = 0;

 private:
  std::int64_t max_horizon_ns_;
  MotionSample newest_;
};

std::unique_ptr<Predictor> makePredictor(const PredictorConfig& config);

}  // namespace coherency
