#pragma once

#include <cstdint>

#include "common/motion/MotionSample.h"

namespace coherency {

/// More than this between two samples and the later one says nothing about the motion between them.
inline constexpr std::int64_t kMotionGapNs = 100'000'000;

/// Seconds from `before` to `after`; 0 where motion begins anew with `after`: there is none before, its
/// sequence or time is not above, or it is more than kMotionGapNs later.
double intervalSeconds(const MotionSample& before, const MotionSample& after);

// Motion of a DOF in its integer units (MotionSample.h), as doubles where it is computed with.

/// Limbs and grip move on by themselves; stick and pedals are commands, of which no next value is to be
/// guessed.
bool movesOn(Dof dof);

/// From `from` to `to`; for an angle the shorter way round, exact across +-180 degrees.
double displacement(Dof dof, std::int32_t from, std::int32_t to);

/// `units` moved on, to the nearest unit and no farther than the DOF's range goes (DofInfo); an angle with
/// the range of a whole turn goes round. `by` may be any finite number; an angle moves by half a turn at
/// most.
std::int32_t moved(Dof dof, std::int32_t units, double by);

}  // namespace coherency
