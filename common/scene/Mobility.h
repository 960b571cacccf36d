#pragma once

#include <cstdint>

#include "common/scene/Light.h"

namespace coherency {

class VRObject;

/// What an object says of itself by the attributes Moving and Fixed (Light.h), whatever it is part of.
enum class Mobility : std::uint8_t {
  Undeclared,  ///< to be found out
  Fixed,
  Moving,
};

/// Throws std::invalid_argument, naming the object's path, where it is declared both.
Mobility mobility(const VRObject& object);

}  // namespace coherency
