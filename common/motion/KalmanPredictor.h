#pragma once

#include <array>

#include "common/motion/Predictor.h"

namespace coherency {

/// What a filter assumes of a DOF. Only the ratio of its two noises decides how the filter weighs what it
/// sees, so that it is one figure for all amplitudes and units.
struct MotionNoise {
  double
      jerk_to_noise;  ///< densities of jerk (unit^2/s^5) over those of the readings' noise (unit^2 s), 1/s^6
  double acceleration_s;  ///< acceleration decays with this time constant
};

/// A Kalman filter for each DOF with the model of R. A. Singer, "Estimating optimal tracking filter
/// performance for manned maneuvering targets", IEEE Trans. AES-6(4), 1970, section III: position, velocity
/// and an acceleration that decays. The process noise of a step is that of white jerk, which Singer's becomes
/// where a step is short beside the decay. The readings' noise is given as a density (variance of a reading =
/// density / interval): a recording of 120 Hz that is played at 1 kHz tells no more of the motion than
/// before, and what the filter remembers is a time and no number of samples. A limb is predicted from its
/// newest reading by the filter's velocity and acceleration; from the filter's position it would lag by a
/// fraction of a millimetre.
class KalmanPredictor final : public Predictor {
 public:
  using Predictor::Predictor;
  static const MotionNoise& noise(Dof dof);

 private:
  /// In units, about the newest reading, so that angles have no seam.
  struct Track {
    std::array<double, 3> state{};                      ///< position, velocity, acceleration
    std::array<std::array<double, 3>, 3> covariance{};  ///< over the density of the readings' noise
    bool started = false;
  };

  void observe(const MotionSample& sample, double interval_s) override;
  double travel(Dof dof, double horizon_s) const override;

  std::array<Track, kDofCount> tracks_{};
};

}  // namespace coherency
