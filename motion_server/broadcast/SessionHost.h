#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/sync/Clock.h"
#include "common/wire/ControlChannel.h"
#include "common/wire/DatagramCodec.h"
#include "common/wire/SealedDatagram.h"
#include "motion_server/broadcast/Broadcaster.h"
#include "motion_server/broadcast/MessageBudget.h"
#include "motion_server/broadcast/MotionSender.h"
#include "motion_server/broadcast/StereoAgreement.h"

namespace coherency {

/// The server's side of the protocol without its sockets: who is connected, what each may say and is
/// answered, who is sent motion. Times and random numbers are passed in. Not thread-safe.
class SessionHost {
 public:
  using Random = std::function<Key()>;
  static constexpr int kStrangers = 16;  ///< connections that may be open beside those of welcome clients
  static constexpr std::int64_t kMessagesPerSecond = 50;
  static constexpr std::int64_t kMessagesAtOnce = 100;
  static constexpr std::int64_t kLingerNs =
      500'000'000;  ///< for a goodbye to arrive before the connection is cut

  /// `session`: what clients are given; its id and motion key are drawn here, its UDP port must be filled in.
  SessionHost(const BroadcastConfig& config, const SessionConfig& session, Random random);
  ~SessionHost();

  std::uint64_t sessionId() const { return session_.session_id; }
  const Key& motionKey() const { return session_.motion_key; }

  /// What a connection is sent and whether that was the last.
  struct Reaction {
    std::vector<std::byte> send;
    bool goodbye = false;
    bool wants_keyframes = false;   ///< all that are needed are to be said to it
    std::optional<Mode> mode = {};  ///< that the client asks for
  };
  /// A number for the connection.
  std::uint32_t open(const std::string& address, ServerTime now);
  /// The connection to cut so that no more than kStrangers are without welcome: of those the oldest, as a
  /// client says hello at once. Asked after each open().
  std::optional<std::uint32_t> surplus() const;
  Reaction receive(std::uint32_t connection, std::span<const std::byte> bytes, ServerTime now);
  /// Bytes that say something to a welcomed client; none to others.
  std::vector<std::byte> tell(std::uint32_t connection, const ControlMessage& message);
  /// The connection is gone. Unknown numbers are passed over.
  void close(std::uint32_t connection);
  /// Connections to cut now: silent for too long, or past their goodbye.
  std::vector<std::uint32_t> expired(ServerTime now) const;

  /// A datagram that arrived, opened in place; whom to answer and what, but for the time of answering. From
  /// its first probe on a client is sent motion where its newest probe came from.
  struct Answer {
    std::uint32_t client;
    ClockReply reply;
  };
  std::optional<Answer> datagram(std::span<std::byte> bytes, const UdpAddress& from, ServerTime arrived);
  /// The whole datagram. Precondition: datagram() has just given the answer.
  void encode(const Answer& answer, std::vector<std::byte>& out);

  /// Grows whenever targets() changes.
  std::uint64_t targetsVersion() const { return targets_version_; }
  std::vector<MotionTarget> targets() const;
  /// Whose motion goes over TCP; and that a packet of it was sent, or could not be.
  std::vector<std::uint32_t> tunnels() const;
  void countTunnelled(std::uint32_t client, bool sent);
  std::vector<std::uint32_t> welcomedClients() const;
  /// The newest keyframe that all who are sent motion say they have; ~0 where there is nobody.
  std::uint32_t keyframeOfAll() const;

  std::vector<ClientStatus> clients() const;
  /// How many were welcomed so far.
  std::uint64_t served() const { return served_; }
  const RejectCounts& rejected() const { return rejected_; }
  const StereoStatus& stereo() const { return stereo_.status(); }
  /// Who was turned away since the last call and why, a line each for people; of many the newest.
  std::vector<std::string> takeRefusals();
  /// What clients said of frames since the last call.
  std::vector<FrameReport> takeReports() { return std::exchange(reports_, {}); }

 private:
  enum class Stage { Stranger, Greeted, Welcomed, Leaving };
  struct Client;
  Reaction on(Client& client, const Hello& hello, ServerTime now);
  Reaction on(Client& client, const Join& join, ServerTime now);
  Reaction on(Client& client, const ClientReport& report, ServerTime now);
  Reaction on(Client& client, const Goodbye& goodbye, ServerTime now);
  Reaction on(Client& client, const ModeRequest& request, ServerTime now);
  Reaction on(Client& client, const KeyframeRequest& request, ServerTime now);
  Reaction on(Client& client, const Tunnelled& tunnelled, ServerTime now);
  Reaction on(Client& client, const SessionConfig& misplaced, ServerTime now);
  Reaction on(Client& client, const Keyframe& misplaced, ServerTime now);
  Reaction react(Client& client, const DecodedControl& decoded, ServerTime now);
  Reaction reject(Client& client, Reject reject);
  Reaction sendAway(Client& client, GoodbyeCause cause, const std::string& reason);
  Reaction say(Client& client, const ControlMessage& message);
  void heard(Client& client, const ClockProbe& probe, MotionWay way, const UdpAddress& from);
  std::size_t welcomed() const { return welcomedClients().size(); }
  void count(Reject reject);

  BroadcastConfig config_;
  SessionConfig session_;
  Random random_;
  DatagramCodec codec_;
  KeyframeStore no_keyframes_;  // what clients send counts from none
  std::uint32_t next_id_ = 1;
  std::map<std::uint32_t, std::unique_ptr<Client>>
      clients_;                    ///< by connection, which is also the client's id
  std::deque<ClientStatus> past_;  ///< of clients that were welcomed, the newest
  std::uint64_t served_ = 0;
  RejectCounts rejected_;
  StereoAgreement stereo_;
  std::vector<FrameReport> reports_;
  std::deque<std::string> refusals_;
  std::uint64_t targets_version_ = 0;
};

}  // namespace coherency
