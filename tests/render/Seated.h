#pragma once

#include "common/math/Rotation.h"
#include "common/world/Scene.h"
#include "tests/render/Support.h"

namespace coherency {

/// How somebody sits: the head off its neutral place and turned, and where the seat stands.
struct Seat {
  Coord3 lean;
  YawPitchRoll turn;
  BasePose base;
};

/// Puts the scene's operator there, as a received sample would.
void sit(Scene& scene, const Seat& seat);

}  // namespace coherency
