#pragma once

#include <cstddef>
#include <cstdint>

#include "common/wire/Discovery.h"
#include "common/wire/Messages.h"
#include "common/wire/Packets.h"
#include "common/world/Names.h"

namespace coherency {

/// Limits of what the wire carries. Decoders refuse what exceeds them, and encoders must not be given it.
inline constexpr std::size_t kMaxPrevious = 7;  ///< redundant samples in a packet
inline constexpr std::size_t kMaxFrames = 3;    ///< frames in a packet
inline constexpr std::size_t kMaxReportFrames = 500;
inline constexpr std::size_t kMaxKind = 40;  ///< bytes of an object's kind: the largest scene fits a message
inline constexpr std::int64_t kMaxTimeNs = std::int64_t{1} << 60;  ///< 36 years; sums of four cannot overflow
inline constexpr std::int64_t kMinPeriodNs = 100'000;
inline constexpr std::int64_t kMinFrameNs = 1'000'000;
inline constexpr std::int64_t kMaxPeriodNs = 1'000'000'000;

/// Whether a value can be true at all. A DOF marked valid must lie in its range. Of one that is not nothing
/// was measured, and what it holds is a posture that can be drawn whatever it is.
bool isValid(const MotionSample& sample);
/// The above, and previous samples and frames in falling order. Whether the hashes hold is hashHolds()'s
/// question.
bool isValid(const FrameState& frame);
bool isValid(const MotionPacket& packet);
bool isValid(const ClockProbe& probe);
bool isValid(const ClockReply& reply);
bool isValid(const Hello& hello);
bool isValid(const Join& join);
/// Names and places that can be; whether there are such objects is for who makes them to say.
bool isValid(const SceneDescription& scene);
bool isValid(const SampleForm& form);
bool isValid(const SessionConfig& session);
bool isValid(const Keyframe& keyframe);
inline bool isValid(const KeyframeRequest&) {
  return true;
}
bool isValid(const Tunnelled& tunnelled);
bool isValid(const ClientReport& report);
bool isValid(const Goodbye& goodbye);
bool isValid(const ModeRequest& request);
bool isValid(const Announcement& announcement);

/// Whether the hash is that of the state it comes with.
bool hashHolds(const MotionPacket& packet);
bool hashHolds(const FrameState& frame);

}  // namespace coherency
