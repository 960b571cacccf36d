#pragma once

#include <array>
#include <cstddef>

#include "common/motion/Predictor.h"

namespace coherency {

/// Constant velocity: the slope of a least-squares line through the samples of the last kWindowS, or through
/// the last two where the rate is lower. A window of 17 ms, two rows of a recording at 120 Hz, was best of
/// 10, 17, 25, 34 and 50 ms for the head (docs/measurements.md).
class VelocityPredictor final : public Predictor {
 public:
  static constexpr double kWindowS = 0.017;
  using Predictor::Predictor;

 private:
  struct Entry {
    double interval_s = 0.0;  ///< since the entry before
    DofMask valid = 0;
    std::array<std::int32_t, kDofCount> units{};
  };
  static constexpr std::size_t kEntries = 64;  // 17 ms at up to 3.7 kHz; beyond that a shorter window

  void observe(const MotionSample& sample, double interval_s) override;
  double travel(Dof dof, double horizon_s) const override;
  const Entry& before(std::size_t steps) const { return ring_[(last_ + kEntries - steps) % kEntries]; }

  std::array<Entry, kEntries> ring_{};
  std::size_t last_ = 0;
  std::size_t count_ = 0;
};

}  // namespace coherency
