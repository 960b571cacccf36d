#pragma once

#include "common/wire/Packets.h"

namespace coherency {

namespace wire {
class Sample;
class World;
}  // namespace wire

/// Samples and states <-> their messages; for the codecs of this folder alone. The readers take any message
/// and return false where it says what cannot be said; whether what they give is valid is not asked here.

void write(const MotionSample& sample, const SampleForm& form, wire::Sample& out);
bool read(const wire::Sample& in, const SampleForm& form, MotionSample& sample);

/// What of `to` differs from `from`. Precondition: as many movables and doors in both, and `to` not 2^63
/// ticks away.
void writeDifference(const WorldState& from, const WorldState& to, wire::World& out);
bool readDifference(const WorldState& from, const wire::World& in, WorldState& to);

}  // namespace coherency
