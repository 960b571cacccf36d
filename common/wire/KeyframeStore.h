#pragma once

#include <array>
#include <optional>
#include <string>

#include "common/wire/Packets.h"

namespace coherency {

/// The keyframes a receiver counts from: the two newest, as packets may still count from the one before.
class KeyframeStore {
 public:
  /// Takes a keyframe, in whatever order they come. One that is here already and says something else takes
  /// its place, and where they differ first is returned, by the name of the field (StateFields.h).
  std::optional<std::string> add(const Keyframe& keyframe);
  const WorldState* find(std::uint32_t number) const;
  std::uint32_t newest() const;  ///< 0: none
  void clear() { kept_ = {}; }

 private:
  std::array<Keyframe, 2> kept_;
};

/// The first field in which two states differ, by StateFields.h's name; nullopt: none.
std::optional<std::string> firstDifference(const WorldState& a, const WorldState& b);

}  // namespace coherency
