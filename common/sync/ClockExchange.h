#pragma once

#include "common/sync/Clock.h"

namespace coherency {

/// One four-timestamp exchange: the client asks at t0, the server receives at t1 and answers at t2, the
/// client receives at t3. Times lie within 0..2^60 ns, so that no sum or difference of them overflows.
struct ClockExchange {
  ClientTime t0;
  ServerTime t1;
  ServerTime t2;
  ClientTime t3;

  /// Time under way, there and back.
  std::int64_t roundTripNs() const { return (t3 - t0) - (t2 - t1); }
  /// Whether such times can be: nothing arrives before it left.
  bool possible() const { return t3 >= t0 && t2 >= t1 && roundTripNs() >= 0; }
};

}  // namespace coherency
