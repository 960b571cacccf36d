#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/sync/Clock.h"
#include "common/sync/ClockSync.h"
#include "common/wire/DatagramCodec.h"
#include "render_client/receive/SequenceTracker.h"
#include "render_client/receive/ServerLink.h"

namespace coherency {

/// What a link knows, without its sockets: the session, the newest packet, the clock, the counts, the frames
/// to report. The first group of functions is the socket thread's; all others are anybody's.
class LinkState {
 public:
  LinkState(const LinkConfig& config, const Clock& clock) : config_(config), clock_(clock) {}

  void welcomed(const SessionConfig& session);
  void refused(const Goodbye& goodbye);
  /// An attempt failed or the connection ended.
  void disconnected(const std::string& why);
  /// Another major version, found by ourselves.
  void refuseVersion();
  /// What to ask the server now. Precondition: welcomed.
  ClockProbe probe();
  /// Any bytes that came to our port. Whether they are the server's.
  bool datagram(std::span<const std::byte> bytes, ClientTime arrived);
  /// The frames since the last one.
  ClientReport takeReport();

  SessionConfig waitForSession(std::int64_t timeout_ns) const;
  std::optional<SessionConfig> session() const;
  std::optional<ReceivedPacket> newest() const;
  std::optional<ReceivedPacket> atTick(std::uint64_t tick) const;
  void keepFirstFrom(const std::vector<std::uint64_t>& ticks);
  std::optional<ReceivedPacket> firstFrom(std::uint64_t tick) const;
  bool waitForTick(std::uint64_t tick, std::int64_t timeout_ns) const;
  void reportFrame(const FrameReport& frame);
  std::optional<ServerTime> toServer(ClientTime t) const;
  LinkStats stats() const;

 private:
  bool on(MotionPacket& packet, ClientTime arrived);
  bool on(const ClockReply& reply, ClientTime arrived);
  bool on(const ClockProbe&, ClientTime) { return false; }  // never sent to a client
  bool on(Reject, ClientTime) { return false; }
  std::uint64_t newestSequence() const { return newest_ ? newest_->packet.sample.sequence : 0; }
  void remember(const MotionPacket& packet, ClientTime arrived, ClientTime decoded);
  std::string where() const;

  const LinkConfig config_;
  const Clock& clock_;
  DatagramCodec codec_;  // the socket thread's

  mutable std::mutex mutex_;  // guards all that follows
  mutable std::condition_variable changed_;
  std::optional<SessionConfig> session_;
  std::optional<ReceivedPacket> newest_;
  std::array<std::optional<ReceivedPacket>, kRecentPackets> recent_;  ///< by tick modulo their number
  std::map<std::uint64_t, std::optional<ReceivedPacket>> kept_;       ///< by the first tick that will do
  std::optional<std::string> refusal_;                                ///< final: coming again is useless
  std::string last_failure_ = "no answer yet";
  bool connected_ = false;
  std::uint64_t connections_ = 0;
  std::uint64_t rejected_ = 0;
  SequenceTracker tracker_;
  ClockSync offset_;
  std::deque<std::int64_t> asked_;  ///< t0 of the probes that may still be answered
  std::deque<FrameReport> frames_;
};

}  // namespace coherency
