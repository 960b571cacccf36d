#include "common/sync/Clock.h"

#include <chrono>

namespace coherency {

std::int64_t MonotonicClock::nowNs() const {
  // On Linux std::chrono::steady_clock is CLOCK_MONOTONIC.
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace coherency
