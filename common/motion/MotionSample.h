#pragma once

#include <array>
#include <cstdint>

#include "common/motion/Dof.h"

namespace coherency {

/// What the master's 19 DOFs were at one moment: canonical, integer, the same bits everywhere.
struct MotionSample {
  std::uint64_t sequence = 0;       ///< counts samples of a session from 1; 0: none yet
  std::int64_t server_time_ns = 0;  ///< server's monotonic clock at sampling
  std::int64_t device_time_us = 0;  ///< the device's own clock; 0 where it has none
  DofMask valid = 0;                ///< bit set: measured now; clear: the last valid value is held
  std::array<std::int32_t, kDofCount> units{};  ///< um, 2^-32 turns or 2^-30 by DofKind

  double si(Dof dof) const { return siFromUnits(info(dof).kind, units[index(dof)]); }
  bool isValid(Dof dof) const { return (valid & mask(dof)) != 0; }
  bool operator==(const MotionSample&) const = default;
};

}  // namespace coherency
