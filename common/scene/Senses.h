#pragma once

#include <string>

// Attributes for senses other than sight. Consumers: common/world/Hearing.h and common/world/Touch.h.

namespace coherency {

/// Something to be heard, at the object's origin.
struct SoundSource {
  std::string what;        ///< as a listener would put it: "a fan hums"
  double level_db = 40.0;  ///< sound pressure level at 1 m, dB re 20 uPa
};

/// How hard the object's surface, and those of everything below it, push back.
struct Surface {
  std::string material;        ///< "wood"
  double stiffness_n_m = 1e4;  ///< force over depth of indentation, N/m
};

}  // namespace coherency
