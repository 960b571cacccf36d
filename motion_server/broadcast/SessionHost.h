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
#include <vector>

#include "common/sync/Clock.h"
#include "common/wire/ControlFraming.h"
#include "common/wire/DatagramCodec.h"
#include "motion_server/broadcast/Broadcaster.h"
#include "motion_server/broadcast/MessageBudget.h"
#include "motion_server/broadcast/MotionSender.h"
#include "motion_server/broadcast/StereoAgreement.h"

namespace coherency {

/// The server's side of the protocol without its sockets: who is connected, what each may say and is
/// answered, who is sent motion. Times and random numbers are passed in. Not thread-safe.
class SessionHost {
 public:
  using Random = std::function<std::uint64_t()>;
  static constexpr int kStrangers = 16;  ///< connections that may be open beside those of welcome clients
  static constexpr std::int64_t kMessagesPerSecond = 50;
  static constexpr std::int64_t kMessagesAtOnce = 100;
  static constexpr std::int64_t kLingerNs =
      500'000'000;  ///< for a goodbye to arrive before the connection is cut

  /// `session`: what clients are given; its session id is drawn here, its UDP port must be filled in.
  SessionHost(const BroadcastConfig& config, const SessionConfig& session, Random random);

  std::uint64_t sessionId() const { return session_.session_id; }

  /// What a connection is sent and whether that was the last.
  struct Reaction {
    std::vector<std::byte> send;
    bool goodbye = false;
    std::optional<Mode> mode = {};  ///< that the client asks for
  };
  /// A number for the connection.
  std::uint32_t open(const std::string& address, ServerTime now);
  /// The connection to cut so that no more than kStrangers are without welcome: of those the oldest, as a
  /// client says hello at once. Asked after each open().
  std::optional<std::uint32_t> surplus() const;
  Reaction receive(std::uint32_t connection, std::span<const std::byte> bytes, ServerTime now);
  /// The connection is gone. Unknown numbers are passed over.
  void close(std::uint32_t connection);
  /// Connections to cut now: silent for too long, or past their goodbye.
  std::vector<std::uint32_t> expired(ServerTime now) const;

  /// A datagram that arrived; what to answer, but for the time of answering. From its first probe on a client
  /// is sent motion where its newest probe came from.
  std::optional<ClockReply> datagram(std::span<const std::byte> bytes, const UdpAddress& from,
                                     ServerTime arrived);

  /// Grows whenever targets() changes.
  std::uint64_t targetsVersion() const { return targets_version_; }
  std::vector<MotionTarget> targets() const;

  std::vector<ClientStatus> clients() const;
  /// How many were welcomed so far.
  std::uint64_t served() const { return served_; }
  const RejectCounts& rejected() const { return rejected_; }
  const StereoStatus& stereo() const { return stereo_.status(); }

 private:
  enum class Stage { Stranger, Welcomed, Leaving };
  struct Client {
    explicit Client(ServerTime connected)
        : budget(kMessagesPerSecond, kMessagesAtOnce, connected), heard(connected) {}
    Stage stage = Stage::Stranger;
    bool was_welcomed = false;
    std::uint64_t token = 0;
    ClientStatus status;
    ControlFraming framing;
    MessageBudget budget;
    ServerTime heard;  ///< or connected, or said goodbye to
    UdpAddress udp;
    std::shared_ptr<SendCounts> counts = std::make_shared<SendCounts>();
  };

  Reaction on(Client& client, const Hello& hello);
  Reaction on(Client& client, const ClientReport& report);
  Reaction on(Client& client, const Goodbye& goodbye);
  Reaction on(Client& client, const ModeRequest& request);
  Reaction on(Client& client, const SessionConfig& misplaced);
  Reaction on(Client& client, Reject reject);
  Reaction sendAway(Client& client, GoodbyeCause cause, const std::string& reason);
  std::size_t welcomed() const;
  std::uint64_t nonZeroRandom();
  void count(Reject reject);

  BroadcastConfig config_;
  SessionConfig session_;
  Random random_;
  DatagramCodec codec_;
  std::uint32_t next_id_ = 1;
  std::map<std::uint32_t, Client> clients_;  ///< by connection, which is also the client's id
  std::deque<ClientStatus> past_;            ///< of clients that were welcomed, the newest
  std::uint64_t served_ = 0;
  RejectCounts rejected_;
  StereoAgreement stereo_;
  std::uint64_t targets_version_ = 0;
};

}  // namespace coherency
