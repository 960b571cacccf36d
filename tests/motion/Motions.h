#pragma once

#include <cmath>
#include <cstdint>
#include <functional>

#include "common/motion/DofMotion.h"

// Samples of motions that are known for all times.

namespace coherency {

/// Every millisecond from `first_ns` on, all DOFs valid; `si` gives a DOF's value at a time in seconds.
inline MotionSample sampleOf(const std::function<double(Dof, double)>& si, std::int64_t ms,
                             std::int64_t first_ns = 5'000'000'000) {
  MotionSample sample;
  sample.sequence = static_cast<std::uint64_t>(ms) + 1;
  sample.server_time_ns = first_ns + ms * 1'000'000;
  sample.valid = kAllDofs;
  for (std::size_t i = 0; i < kDofCount; ++i)
    sample.units[i] = unitsFromSi(dofTable()[i].kind, si(dofAt(i), static_cast<double>(ms) * 1e-3));
  return sample;
}

/// Between two units of a DOF in SI, angles the shorter way.
inline double difference(Dof dof, const MotionSample& a, const MotionSample& b) {
  return displacement(dof, b.units[index(dof)], a.units[index(dof)]) * resolution(info(dof).kind);
}

}  // namespace coherency
