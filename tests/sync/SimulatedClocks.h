#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "common/sync/ClockExchange.h"

namespace coherency {

inline constexpr std::int64_t kUs = 1'000;
inline constexpr std::int64_t kMs = 1'000'000;
inline constexpr std::int64_t kSecond = 1'000'000'000;

/// Two clocks. The client's is the true time; the server's drifts against it and may be set once.
struct SimulatedClocks {
  std::int64_t start_offset_ns = 0;
  double drift_ppm = 0.0;
  std::int64_t drift_turns_ns = 0;  ///< the drift changes its sign this often; 0: never
  std::int64_t step_at_ns = 0;
  std::int64_t step_ns = 0;

  std::int64_t offsetAt(std::int64_t t) const {
    std::int64_t drifting = t;
    if (drift_turns_ns > 0) drifting = drift_turns_ns - std::abs(t % (2 * drift_turns_ns) - drift_turns_ns);
    return start_offset_ns + std::llround(static_cast<double>(drifting) * drift_ppm * 1e-6) +
           (t >= step_at_ns ? step_ns : 0);
  }
  ClockExchange exchange(std::int64_t at, std::int64_t there, std::int64_t serving, std::int64_t back) const {
    const std::int64_t arrives = at + there;
    const std::int64_t leaves = arrives + serving;
    return {{at}, {arrives + offsetAt(arrives)}, {leaves + offsetAt(leaves)}, {leaves + back}};
  }
};

/// What happens to datagrams on their way: a least delay, exponential jitter, and now and then, one way or
/// the other, a long wait for a processor or a queue.
struct SimulatedPath {
  std::int64_t there_ns = 30 * kUs;
  std::int64_t back_ns = 30 * kUs;
  std::int64_t jitter_ns = 3 * kUs;
  double delayed_share = 0.0;
  std::int64_t delay_ns = 0;  ///< mean
};

/// Asks as a client does: eight times within 35 ms, then ten times a second.
class SimulatedProbes {
 public:
  SimulatedProbes(const SimulatedClocks& clocks, const SimulatedPath& path, unsigned seed)
      : clocks_(clocks), path_(path), random_(seed) {}

  ClockExchange next() {
    std::int64_t there = path_.there_ns + around(path_.jitter_ns);
    std::int64_t back = path_.back_ns + around(path_.jitter_ns);
    if (std::bernoulli_distribution(path_.delayed_share)(random_))
      (std::bernoulli_distribution(0.5)(random_) ? there : back) += around(path_.delay_ns);
    const ClockExchange exchange = clocks_.exchange(asks_, there, 2 * kUs, back);
    asks_ = std::max(asks_ + (++asked_ < 8 ? 5 * kMs : 100 * kMs), exchange.t3.ns);
    return exchange;
  }

 private:
  std::int64_t around(std::int64_t mean_ns) {
    return std::llround(static_cast<double>(mean_ns) * std::exponential_distribution<double>()(random_));
  }

  SimulatedClocks clocks_;
  SimulatedPath path_;
  std::mt19937 random_;
  std::int64_t asks_ = kSecond;
  int asked_ = 0;
};

}  // namespace coherency
