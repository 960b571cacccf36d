#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>

namespace coherency {

/// A point in time on one clock, in nanoseconds. Times of different clocks are different types and cannot be
/// mixed; ClockSync alone converts.
template <class WhichClock>
struct Time {
  std::int64_t ns = 0;
  auto operator<=>(const Time&) const = default;
  friend Time operator+(Time t, std::int64_t duration_ns) { return {t.ns + duration_ns}; }
  friend Time operator-(Time t, std::int64_t duration_ns) { return {t.ns - duration_ns}; }
  friend std::int64_t operator-(Time a, Time b) { return a.ns - b.ns; }
};

using ServerTime = Time<struct ServerClockTag>;
using ClientTime = Time<struct ClientClockTag>;

/// Clocks are passed in, so that tests decide what time it is.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual std::int64_t nowNs() const = 0;
  /// Returns when it is that late, at once where it is later.
  virtual void sleepUntil(std::int64_t ns) const = 0;
};

/// CLOCK_MONOTONIC of this machine.
class MonotonicClock final : public Clock {
 public:
  std::int64_t nowNs() const override;
  void sleepUntil(std::int64_t ns) const override;
};

/// Stands still until told otherwise; who sleeps by it makes it later.
class ManualClock final : public Clock {
 public:
  std::int64_t nowNs() const override { return now_ns_; }
  void sleepUntil(std::int64_t ns) const override { now_ns_ = std::max(now_ns_, ns); }
  void advance(std::int64_t ns) { now_ns_ += ns; }

 private:
  mutable std::int64_t now_ns_ = 0;
};

}  // namespace coherency
