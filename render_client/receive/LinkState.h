#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/sync/Clock.h"
#include "common/sync/ClockSync.h"
#include "common/wire/DatagramCodec.h"
#include "common/wire/Handshake.h"
#include "common/wire/SealedDatagram.h"
#include "render_client/receive/FrameBuffer.h"
#include "render_client/receive/SequenceTracker.h"
#include "render_client/receive/ServerLink.h"

namespace coherency {

/// What a link knows, without its sockets: the session, keyframes, the newest packet, the frames to draw, the
/// clock, the counts, what to report. The first group of functions is the socket thread's; all others are
/// anybody's.
class LinkState {
 public:
  /// What arriving bytes were.
  enum class Heard : std::uint8_t {
    Nothing,  ///< not the server's
    Again,    ///< the server's, and here before: what comes by two ways comes twice
    Reply,    ///< to a probe
    Motion,
  };

  LinkState(const LinkConfig& config, const Clock& clock) : config_(config), clock_(clock) {}

  void welcomed(const SessionConfig& session, const ConnectionKeys& keys);
  void refused(const Goodbye& goodbye);
  /// An attempt failed or the connection ended.
  void disconnected(const std::string& why);
  /// Another major version, found by ourselves.
  void refuseVersion();
  void take(const Keyframe& keyframe);
  /// A probe by which to ask the server now, whole for UDP or as a body for TCP. Precondition: welcomed.
  void encodeProbe(MotionWay way, std::vector<std::byte>& datagram);
  Tunnelled tunnelledProbe();
  /// Any bytes that came to our ports, opened in place.
  Heard datagram(std::span<std::byte> bytes, ClientTime arrived);
  Heard tunnelled(const Tunnelled& tunnelled, ClientTime arrived);
  /// What became of frames since the last one.
  ClientReport takeReport();
  /// Once after each requestKeyframe().
  bool takeKeyframeWish();
  /// By which motion comes now.
  void setWay(MotionWay way);

  SessionConfig waitForSession(std::int64_t timeout_ns) const;
  std::optional<SessionConfig> session() const;
  std::uint64_t sessionId() const;
  std::optional<ReceivedPacket> newest() const;
  bool waitForTick(std::uint64_t tick, std::int64_t timeout_ns) const;
  std::optional<ReceivedFrame> nextFrame(std::uint64_t after, std::uint64_t stride, ServerTime earliest,
                                         std::int64_t draw_ns) const;
  std::vector<ReceivedFrame> framesBetween(std::uint64_t after, std::uint64_t before,
                                           std::uint64_t stride) const;
  std::uint64_t newestFrame() const;
  bool waitForFrame(std::uint64_t number, std::int64_t timeout_ns) const;
  void keepFirstFrom(const std::vector<std::uint64_t>& numbers);
  std::optional<ReceivedFrame> firstFrom(std::uint64_t number) const;
  void reportFrame(const FrameReport& frame);
  void requestKeyframe();
  std::optional<ServerTime> toServer(ClientTime t) const;
  std::optional<ClientTime> toClient(ServerTime t) const;
  LinkStats stats() const;

 private:
  Heard take(std::variant<Reject, std::span<const std::byte>> opened, ClientTime arrived);
  Heard on(MotionPacket& packet, ClientTime arrived);
  Heard on(const ClockReply& reply, ClientTime arrived);
  Heard on(const ClockProbe&, ClientTime) { return count(Reject::Malformed); }  // never sent to a client
  Heard on(Reject reject, ClientTime) { return count(reject); }
  Heard count(Reject reject);
  ClockProbe probe(MotionWay way);
  std::string where() const;

  const LinkConfig config_;
  const Clock& clock_;

  mutable std::mutex mutex_;  // guards all that follows
  mutable std::condition_variable changed_;
  std::optional<SessionConfig> session_;
  std::optional<DatagramCodec> codec_;
  std::optional<DatagramOpener> motion_opener_;  ///< of the session
  std::optional<DatagramOpener> reply_opener_;   ///< of this connection
  std::optional<DatagramSealer> probe_sealer_;
  KeyframeStore keyframes_;
  std::optional<ReceivedPacket> newest_;
  FrameBuffer frames_;
  std::optional<std::string> refusal_;  ///< final: coming again is useless
  std::string last_failure_ = "no answer yet";
  LinkStats stats_;  ///< what is not found elsewhere
  SequenceTracker tracker_;
  ClockSync clocks_;
  std::deque<std::int64_t> asked_;  ///< t0 of the probes that may still be answered
  std::deque<FrameReport> reports_;
  bool keyframe_wished_ = false;
};

}  // namespace coherency
