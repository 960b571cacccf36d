#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/sync/Clock.h"
#include "common/wire/Messages.h"
#include "common/wire/Packets.h"
#include "motion_server/broadcast/StereoAgreement.h"

namespace coherency {

struct BroadcastConfig {
  std::string address = "127.0.0.1";  ///< IPv4 or IPv6 to listen on
  std::uint16_t port = kDefaultPort;  ///< TCP and UDP; 0 takes any free one
  int redundancy = 2;                 ///< earlier samples in each packet
  int max_clients = 64;
  std::int64_t silence_ns = 2'000'000'000;  ///< a client not heard of for this long is dropped
  Key key = kNoKey;                         ///< that clients must have
};

struct ClientStatus {
  std::uint32_t id = 0;
  std::string address;
  std::string eye;
  std::string way;  ///< its motion goes by udp, multicast or tcp; empty: it has not asked yet
  std::uint64_t packets_sent = 0;
  std::uint64_t packets_not_sent = 0;  ///< the socket would have blocked
  ClientReport last_report;            ///< without frames
  bool connected = true;
};

/// Everything that reached the ports and was not understood, by cause; nothing else changes because of it.
struct RejectCounts {
  std::uint64_t malformed = 0;  ///< no packet of ours
  std::uint64_t foreign =
      0;  ///< of nobody who is here, or with a key where there is none and the other way round
  std::uint64_t oversized = 0;
  std::uint64_t version = 0;   ///< another major version
  std::uint64_t forged = 0;    ///< not sealed with the keys of whom it claims to be from
  std::uint64_t replayed = 0;  ///< genuine, and here before (a network may do that, too)
};

/// Sends motion to every client that has said hello: control over TCP, motion over UDP (design, "Transport").
/// Owns one thread for all sockets; publish() sends from the caller's thread so that a sample is on the wire
/// within microseconds of being taken. A client that stalls loses datagrams and nothing else happens.
class Broadcaster {
 public:
  /// Binds both ports and starts. Throws std::runtime_error naming address, port and reason when it cannot.
  /// `session` is what each client is given, with ids, key and port filled in. Outlived by `clock`.
  Broadcaster(const BroadcastConfig& config, const SessionConfig& session, const Clock& clock);
  ~Broadcaster();
  Broadcaster(const Broadcaster&) = delete;
  Broadcaster& operator=(const Broadcaster&) = delete;

  /// Encodes once and sends to every client; never blocks. One thread at a time. Fills in keyframe, hash and
  /// the redundant samples; `frame` is a new one to be drawn, where there is one.
  void publish(const WorldState& world, const MotionSample& sample, const std::optional<FrameState>& frame);

  /// Who was turned away since the last call and why, a line each.
  std::vector<std::string> takeRefusals();
  /// What clients said of frames since the last call; nothing where it would have to wait for it, so that the
  /// sampling thread may ask.
  std::vector<FrameReport> takeReports();

  /// The mode a client asked for since the last call, if one did.
  std::optional<Mode> takeModeRequest();

  std::uint16_t port() const;
  std::vector<ClientStatus> clients() const;  ///< present and past
  std::size_t present() const;                ///< clients that are connected now
  std::uint64_t served() const;               ///< clients that were welcomed so far
  RejectCounts rejected() const;
  StereoStatus stereo() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace coherency
