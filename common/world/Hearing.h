#pragma once

#include <string>
#include <vector>

#include "common/scene/VRObject.h"

namespace coherency {

/// Something that is heard (SoundSource, common/scene/Senses.h).
struct Heard {
  std::string what;
  double level_db = 0.0;  ///< at the ear
  double distance_m = 0.0;
  double bearing_rad = 0.0;  ///< from straight ahead, in the ear frame's plane; positive to the left
};

/// What can be heard from here, loudest first: every sound source under `root` whose level at the ear is at
/// least `threshold_db`. Sound spreads from a point (6 dB less each time the distance doubles, no nearer than
/// 0.1 m); walls do not hold it back. The ear's frame: -z ahead, y up.
std::vector<Heard> heardFrom(const VRObject& root, const TransformMatrix& t_world_ear,
                             double threshold_db = 20.0);

/// As a sentence: "a fan hums 2.1 m to the left (31 dB), a clock ticks 3.4 m behind (24 dB)"; "nothing" for
/// silence.
std::string describe(const std::vector<Heard>& heard);

}  // namespace coherency
