#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/world/World.h"

namespace coherency {

/// Version of the bytes of a snapshot. Any change of WorldState's fields makes another.
inline constexpr std::uint16_t kSnapshotLayout = 1;

/// The whole state: "COHS", the layout's version (uint16), then every field little-endian in
/// forEachField()'s order.
std::vector<std::byte> snapshot(const WorldState& state);

/// The state a snapshot was taken of. Throws std::runtime_error naming what is wrong: no snapshot, another
/// layout version, cut short, longer than it should be, more movables or doors than a state holds, a field
/// that no state can have, or a state that is not one of `world`'s.
WorldState restore(std::span<const std::byte> bytes, const World& world);

}  // namespace coherency
