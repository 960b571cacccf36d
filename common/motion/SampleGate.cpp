#include "common/motion/SampleGate.h"

#include <cassert>
#include <cmath>

namespace coherency {

namespace {

bool admissible(const DofInfo& dof, double si) {
  return std::isfinite(si) && si >= dof.min && si <= dof.max;
}

}  // namespace

SampleGate::SampleGate(const std::array<double, kDofCount>& neutral_si) {
  for (std::size_t i = 0; i < kDofCount; ++i) {
    assert(admissible(dofTable()[i], neutral_si[i]));
    held_[i] = unitsFromSi(dofTable()[i].kind, neutral_si[i]);
  }
}

MotionSample SampleGate::admit(const MasterReading& reading, std::uint64_t sequence,
                               std::int64_t server_time_ns) {
  MotionSample sample;
  sample.sequence = sequence;
  sample.server_time_ns = server_time_ns;
  sample.device_time_us = reading.device_time_us;
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const DofMask bit = mask(dofAt(i));
    if ((reading.valid & bit) == 0) continue;
    const DofInfo& dof = dofTable()[i];
    if (!admissible(dof, reading.si[i])) {
      ++refused_[i];
      continue;
    }
    held_[i] = unitsFromSi(dof.kind, reading.si[i]);
    sample.valid |= bit;
  }
  sample.units = held_;
  return sample;
}

}  // namespace coherency
