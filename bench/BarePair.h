#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <netinet/in.h>

#include "common/sync/Clock.h"
#include "common/sync/DurationHistogram.h"

namespace coherency {

/// The floor of one-way latency over loopback: one thread blocks in recv() while another sends datagrams that
/// carry the time of their sending. Made before a fork, each process has one end.
class BarePair {
 public:
  /// Ends the program, saying why, where there are no sockets. Precondition: bytes >= 8.
  explicit BarePair(std::size_t bytes);
  ~BarePair();
  BarePair(const BarePair&) = delete;
  BarePair& operator=(const BarePair&) = delete;

  void send(const Clock& clock);
  /// Ends receive() at the other end.
  void end();
  /// Adds the latency of each datagram until the end comes.
  void receive(const Clock& clock, DurationHistogram& latency);

 private:
  int receiver_, sender_;
  sockaddr_in to_{};
  std::vector<std::byte> datagram_;
};

/// A line of a report: median, p99 and maximum in microseconds, and of how many.
std::string latencyLine(const std::string& what, const DurationHistogram& latency);
/// "1.20 at the median, 1.22 at p99".
std::string latencyRatio(const DurationHistogram& of, const DurationHistogram& to);

}  // namespace coherency
