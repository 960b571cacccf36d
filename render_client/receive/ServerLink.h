#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "common/sync/Clock.h"
#include "common/wire/Packets.h"

namespace coherency {

struct LinkConfig {
  std::string host;
  std::uint16_t port = kDefaultPort;
  std::string eye;
};

struct LinkStats {
  std::uint64_t received = 0;   ///< motion packets accepted
  std::uint64_t lost = 0;       ///< sequence numbers that never came by themselves
  std::uint64_t recovered = 0;  ///< of those, brought by a later packet's redundant samples
  std::uint64_t rejected = 0;   ///< malformed, foreign, of the wrong session
  std::uint64_t reordered = 0;  ///< older than the newest: counted, not shown
  std::uint64_t connections = 0;
  bool connected = false;
  bool clock_known = false;
  std::int64_t clock_offset_ns = 0;  ///< server minus client
  std::int64_t clock_bound_ns = 0;   ///< the truth is within this of it
  double clock_skew_ppm = 0.0;       ///< how much faster the server's clock is
};

/// A packet and when it came, on this machine's clock.
struct ReceivedPacket {
  MotionPacket packet;
  ClientTime arrived;  ///< as bytes
  ClientTime decoded;  ///< as something to draw from
};

inline constexpr std::size_t kRecentPackets = 1024;

/// The client's end of the wire. A thread of its own connects, says hello, receives, measures the clock, and
/// connects again by itself (every 200 ms) when the server goes away. The newest packet wins; nothing queues.
class ServerLink {
 public:
  /// Starts connecting at once. `clock` outlives the link.
  ServerLink(const LinkConfig& config, const Clock& clock);
  ~ServerLink();
  ServerLink(const ServerLink&) = delete;
  ServerLink& operator=(const ServerLink&) = delete;

  /// Waits for the first welcome. Throws std::runtime_error naming host, port, reason and remedy if none
  /// comes in time, or at once when the server refuses this version.
  SessionConfig waitForSession(std::int64_t timeout_ns);
  /// The session in force; a number that changes tells that the server was replaced by another session.
  std::optional<SessionConfig> session() const;

  /// Newest packet of the session in force, if one came; does not consume it.
  std::optional<ReceivedPacket> newest() const;
  /// The packet of exactly this tick, if it came and is among the last kRecentPackets; without redundant
  /// samples.
  std::optional<ReceivedPacket> atTick(std::uint64_t tick) const;
  /// From now on the first packet of each of these ticks or after it is kept, and of no others: a server that
  /// was held up leaves ticks out, the same for all its clients.
  void keepFirstFrom(const std::vector<std::uint64_t>& ticks);
  /// The one that was kept, however long ago it came; none where nothing so late has come.
  std::optional<ReceivedPacket> firstFrom(std::uint64_t tick) const;
  /// Blocks until a packet of this tick or a later one is there, or the time is over.
  bool waitForTick(std::uint64_t tick, std::int64_t timeout_ns) const;

  /// To be told to the server with the next report (twice a second).
  void reportFrame(const FrameReport& frame);
  /// Asks the server for another mode; heard within a round trip, or not at all where there is no connection.
  void requestMode(Mode mode);
  /// Server time of a client time; nullopt until the clock is known.
  std::optional<ServerTime> toServer(ClientTime t) const;
  LinkStats stats() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace coherency
