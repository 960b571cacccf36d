#pragma once

#include <cstdint>

#include "common/sync/Clock.h"

namespace coherency {

/// Client time to server time, never stepped: each new estimate is approached at a limited rate, from where
/// the mapping is. It follows the estimate's skew; a difference is spread over 20 ms, or over as long as it
/// takes at 5 % faster or slower than the client's clock, whichever is longer. Only the first estimate, and
/// one that differs by more than a second (a machine slept), are taken at once.
/// Strictly: piecewise linear, continuous, never decreasing; no rate is outside 1 +- 0.05.
class SlewedMapping {
 public:
  static constexpr double kMaxRate = 0.05;
  static constexpr std::int64_t kSpreadNs = 20'000'000;
  static constexpr std::int64_t kStepNs = 1'000'000'000;

  /// From `now` on the mapping makes for `offset_ns` + `skew` (t - now), `skew` within +-0.01.
  /// Precondition: `now` is not before the last one.
  void steer(ClientTime now, std::int64_t offset_ns, double skew);

  /// Before the last steer() that which was in force then, extended backwards.
  ServerTime toServer(ClientTime t) const;
  ClientTime toClient(ServerTime t) const;  ///< the inverse, to 1 ns

 private:
  struct Ray {
    ClientTime client;
    ServerTime server;
    double rate = 0.0;  ///< server's seconds a second, less 1
    ServerTime toServer(ClientTime t) const;
    ClientTime toClient(ServerTime t) const;
  };

  bool set_ = false;
  Ray before_;   ///< until slewing_ begins
  Ray slewing_;  ///< until arrived_ begins
  Ray arrived_;
};

}  // namespace coherency
