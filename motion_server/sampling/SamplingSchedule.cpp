#include "motion_server/sampling/SamplingSchedule.h"

#include <cassert>

namespace coherency {

SamplingSchedule::SamplingSchedule(std::int64_t start_ns, std::int64_t period_ns)
    : start_ns_(start_ns), period_ns_(period_ns) {
  assert(period_ns > 0);
}

SamplingSchedule::Due SamplingSchedule::take(std::int64_t now_ns) {
  assert(now_ns >= nextDeadline());
  const auto tick = static_cast<std::uint64_t>((now_ns - start_ns_) / period_ns_);
  const Due due{tick, tick - last_};
  missed_ += due.ticks_elapsed - 1;
  last_ = tick;
  return due;
}

}  // namespace coherency
