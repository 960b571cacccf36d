#pragma once

#include <cstddef>
#include <cstdint>

#include "common/wire/Packets.h"
#include "common/world/Names.h"

namespace coherency {

/// Limits of what the wire carries. Decoders refuse what exceeds them, and encoders must not be given it.
inline constexpr std::size_t kMaxPrevious = 7;  ///< redundant samples in a packet
inline constexpr std::size_t kMaxReportFrames = 1000;
inline constexpr std::int64_t kMaxTimeNs = std::int64_t{1} << 60;  ///< 36 years; sums of four cannot overflow
inline constexpr std::int64_t kMinPeriodNs = 100'000;
inline constexpr std::int64_t kMaxPeriodNs = 1'000'000'000;

/// Whether a value can be true at all. A DOF marked valid must lie in its range. Of one that is not nothing
/// was measured, and what it holds is a posture that can be drawn whatever it is.
bool isValid(const MotionSample& sample);
/// The above, and previous samples in falling order of sequence. Whether the hash holds is hashHolds()'s
/// question.
bool isValid(const MotionPacket& packet);
bool isValid(const ClockProbe& probe);
bool isValid(const ClockReply& reply);
/// A Hello of another major version is valid whatever else it says: it must reach who can answer it.
bool isValid(const Hello& hello);
/// Names and places that can be; whether there are such objects is for who makes them to say.
bool isValid(const SceneDescription& scene);
bool isValid(const SessionConfig& session);
bool isValid(const ClientReport& report);
bool isValid(const Goodbye& goodbye);
bool isValid(const ModeRequest& request);

/// Whether the packet's hash is that of its own contents; replicas check it against their own state instead.
bool hashHolds(const MotionPacket& packet);

}  // namespace coherency
