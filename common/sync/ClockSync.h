#pragma once

#include <cstdint>
#include <optional>

#include "common/sync/ClockFit.h"
#include "common/sync/ClockInterval.h"
#include "common/sync/SlewedMapping.h"

namespace coherency {

/// Knows server clock minus client clock from four-timestamp exchanges, in three steps: the interval in which
/// the truth must lie (ClockInterval), the most likely value in it (ClockFit), and a published mapping that
/// is slewed towards that (SlewedMapping). Memory is fixed, no clock is read.
///
/// The first exchange sets the mapping at once. Of those that follow the estimate may jump, the mapping never
/// does: it runs at most 5 % faster or slower than the client's clock. When a clock is set, the first
/// exchange that contradicts the interval makes interval and estimate begin anew, and the mapping slews
/// there, 1 s in 20; only when it is off by more than a second does it jump.
class ClockSync {
 public:
  /// `drift_ppm`: largest difference between the two clocks' rates; CLOCK_MONOTONIC is off by 100 at most by
  /// itself, and is slewed by whoever sets the clock. Within 0..1000.
  explicit ClockSync(double drift_ppm = 300.0);

  /// Returns false, and takes no notice, when the four times contradict each other (t3 < t0, t2 < t1 or a
  /// negative round trip), or when the exchange is from before a step that is known already. Order and
  /// repetition do not matter otherwise.
  bool add(const ClockExchange& exchange);

  bool known() const { return interval_.known(); }
  /// Preconditions of the following: known(). Meant for times about the newest exchange and after.
  ServerTime toServer(ClientTime t) const;  ///< continuous, never decreasing
  ClientTime toClient(ServerTime t) const;  ///< the inverse, to 1 ns
  std::int64_t offsetNs(ClientTime now) const { return toServer(now).ns - now.ns; }
  /// The truth is within this of offsetNs(now), while the clocks keep the drift limit and none is set: the
  /// distance of the mapping from the further end of the interval, so that what is still to be slewed counts.
  std::int64_t boundNs(ClientTime now) const;
  double skewPpm() const { return skew_ * 1e6; }  ///< how much faster the server's clock is

 private:
  double drift_ppm_;
  ClockInterval interval_;
  ClockFit fit_;
  SlewedMapping mapping_;
  double skew_ = 0.0;
  ClientTime asked_{};                 ///< the newest t0
  ClientTime answered_{};              ///< the newest t3
  std::optional<ClientTime> stepped_;  ///< t0 of the exchange that told of the last step
};

}  // namespace coherency
