#pragma once

#include <cstdint>

#include "common/motion/MotionSample.h"

namespace coherency {

/// The compact encoding: 16 bits a DOF, in equal steps over its range (Dof.h). A session that sends codes
/// takes its samples through compacted() before anything is made of them, so that what arrives is exactly
/// what the world was stepped with. A step is 0.31 mm of the head's place, 0.0055 degrees of a whole turn,
/// 0.00003 of a ratio; what a value is off, at most half of that.
std::uint16_t compactCode(Dof dof, std::int32_t units);
/// A code's own value, which has that code again; 65535, which nothing has, is the one below it. 0 of a range
/// about 0 is exact. The two ends of a whole turn are one angle, whose code is 0.
std::int32_t unitsFromCode(Dof dof, std::uint16_t code);
/// The sample with each DOF at its code's value; the rest as it was.
MotionSample compacted(MotionSample sample);

/// The most that a DOF's value is changed by, SI.
double compactError(Dof dof);

}  // namespace coherency
