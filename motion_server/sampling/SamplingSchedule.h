#pragma once

#include <cstdint>

namespace coherency {

/// Absolute deadlines: tick k is due at start + k * period, whatever happened before, so that lateness never
/// adds up. Pure logic; times in nanoseconds of one clock.
class SamplingSchedule {
 public:
  /// Precondition: period_ns > 0.
  SamplingSchedule(std::int64_t start_ns, std::int64_t period_ns);

  struct Due {
    std::uint64_t tick = 0;           ///< the newest whose deadline has come
    std::uint64_t ticks_elapsed = 0;  ///< since the last one taken; more than 1: the others were missed
  };
  /// What to sample at `now_ns`, at or after nextDeadline(), and counts it as taken.
  Due take(std::int64_t now_ns);

  std::int64_t deadline(std::uint64_t tick) const {
    return start_ns_ + static_cast<std::int64_t>(tick) * period_ns_;
  }
  /// The first tick is 1, one period after the start: tick * period has then elapsed.
  std::int64_t nextDeadline() const { return deadline(last_ + 1); }
  std::uint64_t missed() const { return missed_; }
  std::int64_t periodNs() const { return period_ns_; }

 private:
  std::int64_t start_ns_;
  std::int64_t period_ns_;
  std::uint64_t last_ = 0;
  std::uint64_t missed_ = 0;
};

}  // namespace coherency
