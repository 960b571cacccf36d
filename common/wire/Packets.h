#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/body/Rig.h"
#include "common/motion/CompactCode.h"
#include "common/motion/MotionSample.h"
#include "common/sync/Clock.h"
#include "common/wire/Key.h"
#include "common/world/SceneDescription.h"
#include "common/world/WorldState.h"

namespace coherency {

/// Version of the wire, negotiated at Hello: another major is refused, of two minors the lower is spoken, and
/// unknown fields of a newer one are ignored.
inline constexpr std::uint32_t kWireMajor = 3;
inline constexpr std::uint32_t kWireMinor = 0;
inline constexpr std::uint16_t kDefaultPort = 7430;    ///< TCP and UDP
inline constexpr std::uint16_t kDiscoveryPort = 7431;  ///< UDP

/// How samples travel: which DOFs, and how exactly. The others stand still at `still`.
struct SampleForm {
  DofMask dofs = kAllDofs;
  bool compact = false;  ///< 16 bits a DOF instead of 32 (CompactCode.h)
  std::array<std::int32_t, kDofCount> still{};
  bool operator==(const SampleForm&) const = default;
};

/// A group that motion is sent to once for all clients.
struct MulticastGroup {
  std::string address;  ///< IPv4, 224.0.0.0/4
  std::uint16_t port = 0;
  bool operator==(const MulticastGroup&) const = default;
};

/// What the server hands to every client, so that two machines cannot be configured apart.
struct SessionConfig {
  std::uint64_t session_id = 0;  ///< random: another one is another server process
  std::uint32_t client_id = 0;   ///< this client's: the channel of its own datagrams
  Key motion_key{};              ///< of the datagrams that all clients are sent
  SceneDescription scene;
  Rig rig;
  std::int64_t period_ns = 1'000'000;  ///< of sampling
  std::uint16_t udp_port = 0;          ///< where the server's motion comes from and probes go to
  SampleForm form;
  std::int64_t frame_ns = 16'000'000;  ///< from one frame's number to the next
  std::optional<MulticastGroup> multicast;
};

/// What packets count from: the world at one moment. Any later packet and this one are the exact state.
struct Keyframe {
  std::uint32_t number = 0;  ///< from 1; 0: none
  WorldState world;
  bool operator==(const Keyframe&) const = default;
};

/// What one picture shows: the world as it will be when the picture is seen, the same for every eye.
struct FrameState {
  std::uint64_t number = 0;  ///< lengths of a frame since the session began
  MotionSample sample;       ///< predicted; server_time_ns: when the picture is to be seen
  WorldState world;
  std::uint64_t hash = 0;  ///< stateHash(world, sample)
  ServerTime photons() const { return {sample.server_time_ns}; }
  bool operator==(const FrameState&) const = default;
};

/// One datagram of motion: with its keyframe enough by itself to draw from.
struct MotionPacket {
  std::uint32_t keyframe = 0;  ///< the number of the one it counts from
  MotionSample sample;
  WorldState world;
  std::uint64_t hash = 0;              ///< stateHash(world, sample)
  std::vector<MotionSample> previous;  ///< newest first: what a lost packet carried
  std::vector<FrameState> frames;      ///< newest first: those to be seen next
  bool operator==(const MotionPacket&) const = default;
};

/// By which a client is sent its motion.
enum class MotionWay : std::uint8_t {
  Udp,        ///< to where its newest probe came from
  Multicast,  ///< it hears the group
  Tcp,        ///< within control messages, where UDP is blocked
};
inline constexpr std::array<const char*, 3> kMotionWayNames{"udp", "multicast", "tcp"};  ///< by their number

/// Client to server: opens the way for motion, keeps it open, measures the clocks' offset, and says what
/// the client has.
struct ClockProbe {
  std::int64_t t0_client_ns = 0;
  std::uint32_t keyframe = 0;  ///< the newest it has; 0: none
  MotionWay way = MotionWay::Udp;
  bool operator==(const ClockProbe&) const = default;
};
struct ClockReply {
  std::int64_t t0_client_ns = 0;
  std::int64_t t1_server_ns = 0;
  std::int64_t t2_server_ns = 0;
  bool operator==(const ClockReply&) const = default;
};

}  // namespace coherency
