#include "common/scene/Mobility.h"

#include <stdexcept>

#include "common/scene/VRObject.h"

namespace coherency {

Mobility mobility(const VRObject& object) {
  const bool fixed = object.attribute<Fixed>() != nullptr;
  const bool moving = object.attribute<Moving>() != nullptr;
  if (fixed && moving)
    throw std::invalid_argument("VRObject '" + object.path() +
                                "': declared both Fixed and Moving; attach one of them, or neither");
  if (moving) return Mobility::Moving;
  return fixed ? Mobility::Fixed : Mobility::Undeclared;
}

}  // namespace coherency
