#pragma once

#include <cstdint>

#include "common/world/WorldModel.h"
#include "common/world/WorldState.h"

// What cubes do that nobody holds. No general physics: a scene requires that what is let go falls, comes to
// lie flat on what is below it, stays there if its centre is supported, and tips over the edge if it is not;
// that what would stand in something is moved out of it; and that nothing ever moves again without a cause.

namespace coherency {

/// One period of every movable that is not held and does not rest. A solid's top, another movable's top and
/// the floor (y = 0) carry. A movable let go anywhere rests again within a few seconds: one that has been in
/// touch with things for two without finding rest, wedged in a heap, stays as it is. True if any was not at
/// rest.
bool stepBlocks(WorldState& state, const WorldModel& model, std::int64_t period_ns);

/// Wakes what has lost its support, and what is wedged, for whatever wedged it may be gone: to be called when
/// something was taken or let go.
void wakeUnsupported(WorldState& state, const WorldModel& model);

/// Whether three movables stand one upon the other, all at rest.
bool towerStands(const WorldState& state, const WorldModel& model);

}  // namespace coherency
