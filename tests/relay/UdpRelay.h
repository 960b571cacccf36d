#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "common/config/Endpoint.h"
#include "common/sync/Clock.h"
#include "common/sync/DurationHistogram.h"
#include "tests/relay/Impairment.h"

namespace boost::asio {
class io_context;
}

namespace coherency {

struct UdpRelayConfig {
  Endpoint listen, server;  ///< numeric
  std::uint64_t seed = 0;
  std::int64_t flow_silence_ns = 10'000'000'000;
};

/// datagrams + duplicated = lost + in_burst + blocked + sent + not_sent + those that still wait.
struct DirectionStats {
  std::uint64_t datagrams = 0;  ///< that came in
  std::uint64_t lost = 0, in_burst = 0, blocked = 0;
  std::uint64_t duplicated = 0, corrupted = 0;
  std::uint64_t sent = 0;
  std::uint64_t not_sent = 0;  ///< refused by the socket, its flow gone, or too many bytes waiting
  DurationHistogram delay;     ///< of those sent, from their coming in
};

struct UdpRelayStats {
  std::array<DirectionStats, 2> directions;  ///< [0] up, to the server; [1] down, to the clients
  std::uint64_t flows_opened = 0;
  std::uint64_t flows_expired = 0;  ///< by silence
  std::uint64_t flows_evicted = 0;  ///< the most silent one of too many
};

/// Passes datagrams on through an Impairment for each flow and direction. A flow is a client's address, and
/// has a socket of its own towards the server; flows are numbered as they appear, which names their streams.
class UdpRelay {
 public:
  static constexpr std::size_t kMostFlows = 256;

  /// Throws std::runtime_error naming the address that cannot be had. Outlived by `io` and `clock`, which
  /// must be CLOCK_MONOTONIC; not used after `io` has run.
  UdpRelay(boost::asio::io_context& io, const UdpRelayConfig& config, const ImpairmentSettings& settings,
           const Clock& clock);
  ~UdpRelay();
  UdpRelay(const UdpRelay&) = delete;
  UdpRelay& operator=(const UdpRelay&) = delete;

  void change(const ImpairmentSettings& settings);
  const UdpRelayStats& stats() const;
  std::size_t flows() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace coherency
