#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/sync/Clock.h"
#include "common/wire/Packets.h"

namespace coherency {

struct BroadcastConfig {
  std::string address = "127.0.0.1";  ///< IPv4 or IPv6 to listen on
  std::uint16_t port = kDefaultPort;  ///< TCP and UDP; 0 takes any free one
  int redundancy = 2;                 ///< earlier samples in each packet
  int max_clients = 64;
  std::int64_t silence_ns = 2'000'000'000;  ///< a client not heard of for this long is dropped
};

struct ClientStatus {
  std::uint32_t id = 0;
  std::string address;
  std::string eye;
  std::uint64_t packets_sent = 0;
  std::uint64_t packets_not_sent = 0;  ///< the socket would have blocked
  ClientReport last_report;            ///< without frames
  bool connected = true;
};

/// Everything that reached the ports and was not understood, by cause; nothing else changes because of it.
struct RejectCounts {
  std::uint64_t malformed = 0;  ///< no packet of ours
  std::uint64_t foreign = 0;    ///< another session, unknown client or wrong token
  std::uint64_t oversized = 0;
  std::uint64_t version = 0;  ///< another major version
};

/// Agreement between the eyes: pairs of frames of two clients that drew the same sample.
struct StereoStatus {
  std::uint64_t frames_compared = 0;
  std::uint64_t frames_agreeing = 0;
  std::vector<std::int64_t> present_skew_ns;  ///< of the compared pairs, the newest few thousand
};

/// Sends motion to every client that has said hello: control over TCP, motion over UDP (design, "Transport").
/// Owns one thread for all sockets; publish() sends from the caller's thread so that a sample is on the wire
/// within microseconds of being taken. A client that stalls loses datagrams and nothing else happens.
class Broadcaster {
 public:
  /// Binds both ports and starts. Throws std::runtime_error naming address, port and reason when it cannot.
  /// `session` is what each client is given, with ids and port filled in. Outlived by `clock`.
  Broadcaster(const BroadcastConfig& config, const SessionConfig& session, const Clock& clock);
  ~Broadcaster();
  Broadcaster(const Broadcaster&) = delete;
  Broadcaster& operator=(const Broadcaster&) = delete;

  /// Encodes once and sends to every client; never blocks. One thread at a time. Fills in session id, hash
  /// and the redundant samples.
  void publish(const WorldState& world, const MotionSample& sample);

  /// The mode a client asked for since the last call, if one did.
  std::optional<Mode> takeModeRequest();

  std::uint16_t port() const;
  std::vector<ClientStatus> clients() const;  ///< present and past
  std::uint64_t served() const;               ///< clients that were welcomed so far
  RejectCounts rejected() const;
  StereoStatus stereo() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace coherency
