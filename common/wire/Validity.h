#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "common/wire/Packets.h"

namespace coherency {

/// Limits of what the wire carries. Decoders refuse what exceeds them, and encoders must not be given it.
inline constexpr std::size_t kMaxPrevious = 7;  ///< redundant samples in a packet
inline constexpr std::size_t kMaxReportFrames = 1000;
inline constexpr std::size_t kMaxText = 200;                       ///< bytes of a name, a scene or a reason
inline constexpr std::int64_t kMaxTimeNs = std::int64_t{1} << 60;  ///< 36 years; sums of four cannot overflow
inline constexpr std::size_t kMaxSceneObjects = 200;
inline constexpr std::int32_t kMaxObjectCount = 10'000'000;
inline constexpr std::int64_t kMinPeriodNs = 100'000;
inline constexpr std::int64_t kMaxPeriodNs = 1'000'000'000;

/// Whether a value can be true at all. A DOF marked valid must lie in its range; one that is held need not,
/// since the neutral posture of an unusual rig may lie outside.
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

/// Scene names: 1 to kMaxText of a-z, A-Z, 0-9 and `_ - . :`.
bool isSceneName(std::string_view name);
/// At most kMaxText printable ASCII characters: safe to show on a terminal.
bool isPlainText(std::string_view text);
/// `text` made so: other characters become `?`, and what is too long is cut.
std::string plainText(std::string_view text);

/// Whether the packet's hash is that of its own contents; replicas check it against their own state instead.
bool hashHolds(const MotionPacket& packet);

}  // namespace coherency
