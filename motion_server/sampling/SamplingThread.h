#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <thread>

#include "common/sync/DurationHistogram.h"

namespace coherency {

/// One sampling moment. Times are CLOCK_MONOTONIC (MonotonicClock's).
struct SamplingTick {
  std::uint64_t tick = 0;           ///< counts periods since the start, from 1
  std::int64_t elapsed_ns = 0;      ///< tick * period: the time to be sampled
  std::int64_t due_ns = 0;          ///< when it should have woken
  std::int64_t now_ns = 0;          ///< when the thread really woke
  std::uint64_t ticks_elapsed = 0;  ///< since the last callback; more than 1: periods were missed
};

/// How the thread kept its schedule. Readable at any time from any thread.
struct SamplingJitter {
  DurationHistogram lateness;            ///< waking after the deadline
  DurationHistogram period;              ///< from waking to waking
  DurationHistogram deviation;           ///< of that from the periods between, either way
  std::atomic<std::uint64_t> missed{0};  ///< periods without a sample
};

/// A thread that calls back once a period on an absolute schedule (clock_nanosleep, TIMER_ABSTIME). Asks for
/// real-time scheduling and does without where that is not granted.
class SamplingThread {
 public:
  /// Returns false to end the run. Called from the thread.
  using Callback = std::function<bool(const SamplingTick&)>;

  /// Precondition: period_ns > 0.
  SamplingThread(std::int64_t period_ns, Callback callback);
  ~SamplingThread();
  SamplingThread(const SamplingThread&) = delete;
  SamplingThread& operator=(const SamplingThread&) = delete;

  /// Ends the run within a period; does not wait.
  void stop() { stop_.store(true); }
  bool running() const { return running_.load(); }
  /// Waits for the end of the run and rethrows what the callback threw, once.
  void join();

  bool realTime() const { return real_time_.load(); }
  const SamplingJitter& jitter() const { return jitter_; }

 private:
  void run();
  void loop();

  std::int64_t period_ns_;
  Callback callback_;
  SamplingJitter jitter_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> running_{true};
  std::atomic<bool> real_time_{false};
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace coherency
