#include "common/motion/DofMotion.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

constexpr double kHalfTurn = 2147483648.0;  // in units

std::int32_t wrapped(std::int64_t units) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(units));
}

/// The middle of a DOF's range, about which its range has no seam: the shoulder's flexion goes beyond 180
/// degrees.
std::int32_t middle(const DofInfo& dof) {
  return unitsFromSi(dof.kind, 0.5 * (dof.min + dof.max));
}

}  // namespace

double intervalSeconds(const MotionSample& before, const MotionSample& after) {
  if (before.sequence == 0 || after.sequence <= before.sequence) return 0.0;
  if (after.server_time_ns <= before.server_time_ns) return 0.0;
  const std::uint64_t interval_ns =
      static_cast<std::uint64_t>(after.server_time_ns) - static_cast<std::uint64_t>(before.server_time_ns);
  return interval_ns <= static_cast<std::uint64_t>(kMotionGapNs) ? static_cast<double>(interval_ns) * 1e-9
                                                                 : 0.0;
}

bool movesOn(Dof dof) {
  return info(dof).kind != DofKind::Ratio || dof == Dof::Grip;
}

double displacement(Dof dof, std::int32_t from, std::int32_t to) {
  const std::int64_t difference = std::int64_t{to} - from;
  return static_cast<double>(info(dof).kind == DofKind::Angle ? wrapped(difference) : difference);
}

std::int32_t moved(Dof dof, std::int32_t units, double by) {
  assert(std::isfinite(by));
  const DofInfo& range = info(dof);
  const std::int32_t centre = middle(range);
  const double half = 0.5 * (range.max - range.min) / resolution(range.kind);
  double from_centre = displacement(dof, centre, units) + std::clamp(by, -kHalfTurn, kHalfTurn);
  if (range.kind != DofKind::Angle || half < kHalfTurn) from_centre = std::clamp(from_centre, -half, half);
  return wrapped(centre + std::llround(from_centre));
}

}  // namespace coherency
