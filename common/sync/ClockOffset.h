#pragma once

#include <cstdint>
#include <optional>

#include "common/sync/Clock.h"

namespace coherency {

/// One four-timestamp exchange: the client asks at t0, the server receives at t1 and answers at t2, the
/// client receives at t3.
struct ClockExchange {
  ClientTime t0;
  ServerTime t1;
  ServerTime t2;
  ClientTime t3;
};

/// Estimates server clock minus client clock. Whatever the asymmetry of the path, the truth at an exchange
/// lies within half its round trip of what it says; from then on the clocks drift apart by at most
/// `drift_ppm`. Of all exchanges the one counts whose bound is the narrowest now: NTP's clock filter (RFC
/// 5905, section 10) with the age weighed in, which makes a window needless, since the bounds of any two
/// exchanges grow alike.
class ClockOffset {
 public:
  /// `drift_ppm`: largest difference between the two clocks' rates.
  explicit ClockOffset(double drift_ppm = 100.0) : drift_(drift_ppm * 1e-6) {}

  /// Returns false, and takes no notice, when the four times contradict each other (t3 < t0, t2 < t1 or a
  /// negative round trip). An exchange that contradicts the estimate by more than both bounds tells that a
  /// clock was set, and replaces it.
  bool add(const ClockExchange& exchange);

  bool known() const { return best_.has_value(); }
  /// Preconditions of the following: known().
  std::int64_t offsetNs() const;               ///< server minus client
  std::int64_t boundNs(ClientTime now) const;  ///< the truth is within this of offsetNs()
  ServerTime toServer(ClientTime t) const { return {t.ns + offsetNs()}; }
  ClientTime toClient(ServerTime t) const { return {t.ns - offsetNs()}; }

 private:
  struct Estimate {
    ClientTime asked;
    std::int64_t round_trip_ns;
    std::int64_t offset_ns;
  };
  std::int64_t boundNs(const Estimate& estimate, ClientTime now) const;

  double drift_;
  std::optional<Estimate> best_;
};

}  // namespace coherency
