#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/sync/Clock.h"
#include "common/wire/Messages.h"
#include "common/wire/Packets.h"
#include "render_client/receive/FrameBuffer.h"

namespace coherency {

struct LinkConfig {
  std::string host;
  std::uint16_t port = kDefaultPort;
  std::string eye;
  Key key = kNoKey;
};

struct LinkStats {
  std::uint64_t received = 0;          ///< motion packets accepted
  std::uint64_t lost = 0;              ///< sequence numbers that never came by themselves
  std::uint64_t recovered = 0;         ///< of those, brought by a later packet's redundant samples
  std::uint64_t reordered = 0;         ///< older than the newest: counted, not shown
  std::uint64_t rejected = 0;          ///< what came and was not the server's, by whatever cause
  std::uint64_t forged = 0;            ///< of those, not sealed with this session's keys
  std::uint64_t replayed = 0;          ///< the server's, but here before: a network may do that, or somebody
  std::uint64_t without_keyframe = 0;  ///< came before the keyframe that they count from
  std::uint64_t keyframes = 0;
  std::string differing_field;  ///< the first that differed when a keyframe was said again and was another
  std::uint64_t connections = 0;
  bool connected = false;
  MotionWay way = MotionWay::Udp;
  bool clock_known = false;
  std::int64_t clock_offset_ns = 0;  ///< server minus client
  std::int64_t clock_bound_ns = 0;
  double clock_skew_ppm = 0.0;
};

/// A packet and when it came, on this machine's clock.
struct ReceivedPacket {
  MotionPacket packet;
  ClientTime arrived;  ///< as bytes
  ClientTime decoded;  ///< as something to draw from
};

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

  std::uint64_t sessionId() const;  ///< of that; 0: none yet

  /// Newest packet of the session in force, if one came; does not consume it.
  std::optional<ReceivedPacket> newest() const;
  /// Blocks until a packet of this tick or a later one is there, or the time is over.
  bool waitForTick(std::uint64_t tick, std::int64_t timeout_ns) const;

  /// What to draw, as FrameBuffer tells it.
  std::optional<ReceivedFrame> nextFrame(std::uint64_t after, std::uint64_t stride, ServerTime earliest,
                                         std::int64_t draw_ns) const;
  std::vector<ReceivedFrame> framesBetween(std::uint64_t after, std::uint64_t before,
                                           std::uint64_t stride) const;
  void keepFirstFrom(const std::vector<std::uint64_t>& numbers);
  std::optional<ReceivedFrame> firstFrom(std::uint64_t number) const;
  std::uint64_t newestFrame() const;  ///< its number; 0: none has come
  /// Blocks until a frame of this number or a later one is there, or the time is over.
  bool waitForFrame(std::uint64_t number, std::int64_t timeout_ns) const;

  /// To be told to the server with the next report (five times a second), by rising number.
  void reportFrame(const FrameReport& frame);
  /// Asks the server for another mode; heard within a round trip, or not at all where there is no connection.
  void requestMode(Mode mode);
  /// Has the server say the keyframes again, as a state did not have its hash.
  void requestKeyframe();
  /// Server time of a client time and the other way round; nullopt until the clock is known.
  std::optional<ServerTime> toServer(ClientTime t) const;
  std::optional<ClientTime> toClient(ServerTime t) const;
  LinkStats stats() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace coherency
