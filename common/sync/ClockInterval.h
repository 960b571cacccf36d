#pragma once

#include <cstdint>
#include <optional>

#include "common/sync/ClockExchange.h"

namespace coherency {

/// The interval that exchanges prove for server clock minus client clock, whatever the asymmetry of the path.
/// A question arrives after it was asked, so that offset(t0) <= t1 - t0; an answer arrives after it was
/// given, so that offset(t3) >= t2 - t3 (Marzullo and Owicki, "Maintaining the time in a distributed system",
/// 1983). Away from t0 and t3 both weaken by the drift limit. All weaken alike, so that of all exchanges
/// there ever were two hold the intersection from the newest on: the highest lower and the lowest upper
/// bound.
class ClockInterval {
 public:
  struct Bounds {
    std::int64_t low_ns;
    std::int64_t high_ns;
  };

  /// `drift_ppm`: largest difference between the two clocks' rates.
  explicit ClockInterval(double drift_ppm) : drift_(drift_ppm * 1e-6) {}

  bool known() const { return low_.has_value(); }
  /// Returns false, and takes no notice, when the exchange and those before cannot all be true: a clock was
  /// set, or drifts faster than the limit. Precondition: possible().
  bool tighten(const ClockExchange& exchange);
  /// Never empty from the newest t3 on. Precondition: known().
  Bounds at(ClientTime t) const;

 private:
  struct Proof {
    ClientTime at;
    std::int64_t offset_ns;
  };
  bool contradict(const Proof& low, const Proof& high) const;
  double drifted(std::int64_t duration_ns) const { return drift_ * static_cast<double>(duration_ns); }
  std::int64_t widening(const Proof& proof, ClientTime t) const;

  double drift_;
  std::optional<Proof> low_, high_;
};

}  // namespace coherency
