#include "common/sync/Clock.h"

#include <cerrno>
#include <chrono>
#include <system_error>

#include <time.h>

namespace coherency {

std::int64_t MonotonicClock::nowNs() const {
  // On Linux std::chrono::steady_clock is CLOCK_MONOTONIC.
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

void MonotonicClock::sleepUntil(std::int64_t ns) const {
  if (ns <= nowNs()) return;
  timespec until{};
  until.tv_sec = static_cast<time_t>(ns / 1'000'000'000);
  until.tv_nsec = static_cast<long>(ns % 1'000'000'000);
  int code = EINTR;
  while (code == EINTR) code = clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
  if (code != 0) throw std::system_error(code, std::generic_category(), "clock_nanosleep");
}

}  // namespace coherency
