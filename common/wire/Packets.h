#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/body/Rig.h"
#include "common/motion/MotionSample.h"
#include "common/world/SceneDescription.h"
#include "common/world/WorldState.h"

namespace coherency {

/// Version of the wire, negotiated at Hello: another major is refused, unknown fields of a newer minor are
/// ignored.
inline constexpr std::uint32_t kWireMajor = 2;
inline constexpr std::uint32_t kWireMinor = 0;
inline constexpr std::uint16_t kDefaultPort = 7430;  ///< TCP and UDP

/// What the server hands to every client, so that two machines cannot be configured apart.
struct SessionConfig {
  std::uint64_t session_id = 0;    ///< random; datagrams of another session are foreign
  std::uint32_t client_id = 0;     ///< this client's, in its datagrams to the server
  std::uint64_t client_token = 0;  ///< random; proves that a datagram comes from the client that was welcomed
  SceneDescription scene;
  Rig rig;
  std::int64_t period_ns = 1'000'000;  ///< of sampling
  std::uint16_t udp_port = 0;          ///< where the server's motion comes from and probes go to
};

/// One datagram of motion: enough by itself to draw from.
struct MotionPacket {
  std::uint64_t session_id = 0;
  MotionSample sample;
  WorldState world;
  std::uint64_t hash = 0;              ///< stateHash(world, sample)
  std::vector<MotionSample> previous;  ///< newest first: what a lost packet carried
  bool operator==(const MotionPacket&) const = default;
};

/// Client to server over UDP: opens the way for motion, keeps it open, and measures the clocks' offset.
struct ClockProbe {
  std::uint64_t session_id = 0;
  std::uint32_t client_id = 0;
  std::uint64_t client_token = 0;
  std::int64_t t0_client_ns = 0;
  bool operator==(const ClockProbe&) const = default;
};
struct ClockReply {
  std::uint64_t session_id = 0;
  std::int64_t t0_client_ns = 0;
  std::int64_t t1_server_ns = 0;
  std::int64_t t2_server_ns = 0;
  bool operator==(const ClockReply&) const = default;
};

/// Client to server over TCP, first of all.
struct Hello {
  std::uint32_t major = kWireMajor;
  std::uint32_t minor = kWireMinor;
  std::string eye;       ///< "left", "right", "both" or "mono": for the server's stats
  std::string software;  ///< name and version, for people
  bool operator==(const Hello&) const = default;
};
/// What a client drew since its last report: the server certifies that the eyes agree.
struct FrameReport {
  std::uint64_t sequence = 0;  ///< newest sample drawn
  std::uint64_t hash = 0;      ///< of the state as drawn
  std::int64_t presented_server_ns = 0;
  bool operator==(const FrameReport&) const = default;
};
struct ClientReport {
  std::vector<FrameReport> frames;
  std::uint64_t packets_received = 0;
  std::uint64_t packets_lost = 0;
  bool operator==(const ClientReport&) const = default;
};
/// Client to server: whom the operator wishes to be from the next tick on.
struct ModeRequest {
  Mode mode = Mode::Operator;
  bool operator==(const ModeRequest&) const = default;
};
/// Either way: why the connection ends.
enum class GoodbyeCause : std::uint8_t {
  Leaving,   ///< the program ends
  Version,   ///< another major version: coming again is useless
  Full,      ///< too many clients
  Protocol,  ///< something was sent that has no place here
};
struct Goodbye {
  std::string reason;  ///< one line for people
  GoodbyeCause cause = GoodbyeCause::Leaving;
  bool operator==(const Goodbye&) const = default;
};

}  // namespace coherency
