#include "common/motion/CompactCode.h"

#include <algorithm>
#include <cmath>

namespace coherency {
namespace {

constexpr std::int64_t kSteps =
    65534;  // even: the middle of a range, where sticks rest, has a code of its own

/// A DOF's range in its integer unit.
struct UnitRange {
  std::int64_t min;
  std::int64_t width;
};

UnitRange unitRange(Dof dof) {
  const DofInfo& d = info(dof);
  const double unit = resolution(d.kind);
  const std::int64_t min = std::llround(d.min / unit);
  return {min, std::llround(d.max / unit) - min};
}

const std::array<UnitRange, kDofCount>& unitRanges() {
  static const auto ranges = [] {
    std::array<UnitRange, kDofCount> table{};
    for (std::size_t i = 0; i < kDofCount; ++i) table[i] = unitRange(dofAt(i));
    return table;
  }();
  return ranges;
}

/// How far into the range a value is. An angle counts in whole turns from where the range begins, so that one
/// that has wrapped to the other side is where it belongs.
std::int64_t within(Dof dof, std::int32_t units) {
  const UnitRange range = unitRanges()[index(dof)];
  std::int64_t above = units - range.min;
  if (info(dof).kind == DofKind::Angle) {
    above = static_cast<std::int64_t>(static_cast<std::uint64_t>(above) & 0xffffffffU);
    const std::int64_t beyond = above - range.width;
    const std::int64_t below = (std::int64_t{1} << 32) - above;
    if (beyond > 0) return beyond <= below ? range.width : 0;
  }
  return std::clamp<std::int64_t>(above, 0, range.width);
}

}  // namespace

std::uint16_t compactCode(Dof dof, std::int32_t units) {
  const UnitRange range = unitRanges()[index(dof)];
  return static_cast<std::uint16_t>((within(dof, units) * kSteps + range.width / 2) / range.width);
}

std::int32_t unitsFromCode(Dof dof, std::uint16_t code) {
  const UnitRange range = unitRanges()[index(dof)];
  const std::int64_t step = std::min<std::int64_t>(code, kSteps);
  const std::int64_t above = (step * range.width + kSteps / 2) / kSteps;
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(range.min + above));
}

MotionSample compacted(MotionSample sample) {
  for (std::size_t i = 0; i < kDofCount; ++i)
    sample.units[i] = unitsFromCode(dofAt(i), compactCode(dofAt(i), sample.units[i]));
  return sample;
}

double compactError(Dof dof) {
  const DofInfo& d = info(dof);
  return (d.max - d.min) / static_cast<double>(kSteps) / 2.0 + resolution(d.kind);
}

}  // namespace coherency
