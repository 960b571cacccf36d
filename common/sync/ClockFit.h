#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "common/sync/ClockExchange.h"

namespace coherency {

/// Offset and skew between two clocks, from the exchanges with the shortest round trips. Of each second of
/// the last 32 the exchange counts that was under way for the shortest time (NTP's clock filter, RFC 5905,
/// section 10). A line is fitted through their midpoints, weighted by how much longer than the shortest of
/// all each was under way, since its midpoint is off by at most half of that (Veitch, Ridoux, Korada, "Robust
/// synchronization of absolute and difference clocks over networks", IEEE/ACM Transactions on Networking,
/// 2009). That skews are small is known beforehand and counts like one more measurement of the skew, 0 within
/// a tenth of the drift limit: it is what noise has to outweigh.
class ClockFit {
 public:
  struct Line {
    std::int64_t offset_ns;  ///< server minus client, at the time asked for
    double skew;             ///< its growth, seconds a second, within the drift limit; 0 in the first 2 s
  };

  /// `drift_ppm`: largest difference between the two clocks' rates.
  explicit ClockFit(double drift_ppm) : drift_ppm_(drift_ppm) {}

  /// Precondition: exchange.possible().
  void add(const ClockExchange& exchange);
  /// The line at `now`, at or after the newest t3. Precondition: something was added.
  Line at(ClientTime now) const;

 private:
  static constexpr std::size_t kPieces = 32;
  struct Point {
    ClientTime at;  ///< middle of the exchange
    std::int64_t offset_ns;
    std::int64_t round_trip_ns;
  };
  struct Sums;
  double likelySkewPpm() const { return drift_ppm_ / 10; }

  double drift_ppm_;
  std::array<Point, kPieces> points_{};  ///< the shortest of each second, a ring
  std::size_t pieces_ = 0;               ///< begun so far; the newest is at (pieces_ - 1) % kPieces
  ClientTime piece_ends_;
};

}  // namespace coherency
