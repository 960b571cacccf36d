#pragma once

namespace coherency {

struct SineCosine {
  double sine;
  double cosine;
};

/// Sine and cosine made of additions and multiplications alone, so that they are the same bits with every
/// compiler, instruction set and C library (glibc 2.36 and 2.39 disagree on sin(3.81219767052986)): all poses
/// of the system are built from them. Within 1 unit in the last place for angles up to 10^7 rad; beyond,
/// those of the angle's IEEE remainder by kTurn. NaN where the angle is not finite.
SineCosine sineCosine(double angle_rad);

}  // namespace coherency
