#pragma once

#include <array>
#include <cstdint>

#include "common/motion/MotionSample.h"

namespace coherency {

/// A master's reading in SI units before it is trusted.
struct MasterReading {
  std::array<double, kDofCount> si{};
  DofMask valid = kAllDofs;
  std::int64_t device_time_us = 0;
};

/// The edge where readings become samples (design, "Faults"): a value that is NaN, infinite or out of its
/// DOF's range is refused and counted, and the last valid one is held with its validity bit cleared. Before a
/// DOF was ever valid it holds the neutral posture.
class SampleGate {
 public:
  explicit SampleGate(const std::array<double, kDofCount>& neutral_si);

  MotionSample admit(const MasterReading& reading, std::uint64_t sequence, std::int64_t server_time_ns);

  /// How many values of each DOF were refused so far.
  const std::array<std::uint64_t, kDofCount>& refused() const { return refused_; }

 private:
  std::array<std::int32_t, kDofCount> held_{};
  std::array<std::uint64_t, kDofCount> refused_{};
};

}  // namespace coherency
