#pragma once

#include <cstdint>

namespace coherency {

struct WorldModel;
struct WorldState;

/// A stretch of a surface over which movables are strewn at the beginning of a session (paper, section V:
/// "three blocks placed randomly on the table"). World coordinates, m.
struct ScatterArea {
  double min_x = 0.0, max_x = 0.0, min_z = 0.0, max_z = 0.0;
  bool operator==(const ScatterArea&) const = default;
};

/// Moves the movables to random places within the area, at the height they have, each turned at random: clear
/// of one another and of all that stands there or begins there, on something that carries them. The same seed
/// gives the same places. Throws std::invalid_argument naming the one for which there is no room.
void scatter(WorldState& state, const WorldModel& model, const ScatterArea& area, std::uint64_t seed);

}  // namespace coherency
