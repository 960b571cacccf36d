#include "motion_server/sampling/SamplingThread.h"

#include <cstdlib>
#include <utility>

#include <pthread.h>
#include <sched.h>

#include "common/sync/Clock.h"
#include "motion_server/sampling/SamplingSchedule.h"

namespace coherency {

namespace {

constexpr int kPriority = 50;  // below the kernel's own interrupt threads' upper half

bool askForRealTime() {
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

}  // namespace

SamplingThread::SamplingThread(std::int64_t period_ns, Callback callback)
    : period_ns_(period_ns), callback_(std::move(callback)), thread_([this] { run(); }) {}

SamplingThread::~SamplingThread() {
  stop();
  if (thread_.joinable()) thread_.join();
}

void SamplingThread::join() {
  if (thread_.joinable()) thread_.join();
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void SamplingThread::run() {
  real_time_.store(askForRealTime());
  try {
    loop();
  } catch (...) {
    failure_ = std::current_exception();
  }
  running_.store(false);
}

void SamplingThread::loop() {
  const MonotonicClock clock;
  SamplingSchedule schedule(clock.nowNs(), period_ns_);
  std::int64_t woke_before = 0;
  while (!stop_.load()) {
    const std::int64_t deadline = schedule.nextDeadline();
    clock.sleepUntil(deadline);
    const std::int64_t now = clock.nowNs();
    const SamplingSchedule::Due due = schedule.take(now);
    jitter_.lateness.add(now - deadline);
    if (woke_before != 0) {
      jitter_.period.add(now - woke_before);
      jitter_.deviation.add(
          std::abs(now - woke_before - static_cast<std::int64_t>(due.ticks_elapsed) * period_ns_));
    }
    jitter_.missed.store(schedule.missed(), std::memory_order_relaxed);
    woke_before = now;
    const auto elapsed = static_cast<std::int64_t>(due.tick) * period_ns_;
    if (!callback_({due.tick, elapsed, schedule.deadline(due.tick), now, due.ticks_elapsed})) return;
  }
}

}  // namespace coherency
