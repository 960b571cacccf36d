#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "common/config/Endpoint.h"
#include "common/sync/Clock.h"

namespace boost::asio {
class io_context;
}

namespace coherency {

struct TcpRelayStats {
  std::uint64_t connections = 0;
  std::uint64_t refused = 0;             ///< too many at once, or no server answered
  std::uint64_t cut = 0;                 ///< ended by cut()
  std::array<std::uint64_t, 2> bytes{};  ///< passed on; [0] up, to the server; [1] down, to the clients
};

/// Passes TCP on byte for byte, both directions at once. Where one side reads slowly the other one comes to a
/// halt with it; the end of one direction is passed on while the other goes on; a reset resets both sides.
class TcpRelay {
 public:
  static constexpr std::size_t kMostConnections = 256;

  /// Throws std::runtime_error naming the address that cannot be had. Outlived by `io` and `clock`, which
  /// must be CLOCK_MONOTONIC; not used after `io` has run.
  TcpRelay(boost::asio::io_context& io, const Endpoint& listen, const Endpoint& server, std::int64_t delay_ns,
           const Clock& clock);
  ~TcpRelay();
  TcpRelay(const TcpRelay&) = delete;
  TcpRelay& operator=(const TcpRelay&) = delete;

  void change(std::int64_t delay_ns);  ///< for what comes from now on
  void cut();                          ///< resets all connections; new ones are taken
  const TcpRelayStats& stats() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace coherency
