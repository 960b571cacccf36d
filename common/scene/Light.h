#pragma once

#include "common/math/Coord3.h"

// Attributes that image generation reads.

namespace coherency {

/// A lamp that shines from a point, with inverse-square falloff.
struct Light {
  Coord3 position;               ///< m, in the frame of the object that has it
  Coord3 colour{1.0, 1.0, 1.0};  ///< linear RGB
  double intensity = 1.0;        ///< irradiance at 1 m, in units of a white surface's full brightness
  double reach = 8.0;            ///< m; its light has faded to nothing there
};

/// Light from everywhere, where none of it is kept away: from above and from below, linear RGB.
struct Ambient {
  Coord3 sky{0.4, 0.4, 0.4};
  Coord3 ground{0.2, 0.2, 0.2};
};

/// The object and everything below it may move while the world runs. What is not so marked is taken to stay:
/// its geometry and its light are computed once (paper, section III.C.1), and all of it again when it moves.
struct Moving {};

/// The object never moves relative to what it is a member of; below something that moves it moves with that,
/// as one piece. No object may be declared Fixed and Moving (Mobility.h).
struct Fixed {};

}  // namespace coherency
