#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/sync/Clock.h"
#include "common/sync/DurationHistogram.h"
#include "motion_server/sampling/SamplingSchedule.h"
#include "motion_server/sampling/SamplingThread.h"

namespace coherency {
namespace {

TEST(SamplingSchedule, FirstTickIsOnePeriodAfterTheStart) {
  SamplingSchedule schedule(5000, 1000);
  EXPECT_EQ(schedule.nextDeadline(), 6000);
  const auto due = schedule.take(6007);
  EXPECT_EQ(due.tick, 1u);
  EXPECT_EQ(due.ticks_elapsed, 1u);
  EXPECT_EQ(schedule.nextDeadline(), 7000) << "lateness does not add up";
}

TEST(SamplingSchedule, CountsWhatWasMissedAndTakesTheNewest) {
  SamplingSchedule schedule(0, 1000);
  schedule.take(1000);
  const auto due = schedule.take(4999);
  EXPECT_EQ(due.tick, 4u);
  EXPECT_EQ(due.ticks_elapsed, 3u);
  EXPECT_EQ(schedule.missed(), 2u);
  EXPECT_EQ(schedule.nextDeadline(), 5000);
}

RC_GTEST_PROP(SamplingSchedule, EveryPeriodIsCountedOnce, ()) {
  const auto period = *rc::gen::inRange<std::int64_t>(1, 100'000);
  const auto start = *rc::gen::inRange<std::int64_t>(-1'000'000, 1'000'000);
  SamplingSchedule schedule(start, period);
  std::uint64_t elapsed = 0;
  for (int i = 0; i < 50; ++i) {
    const std::int64_t now = schedule.nextDeadline() + *rc::gen::inRange<std::int64_t>(0, 5 * period);
    const auto due = schedule.take(now);
    elapsed += due.ticks_elapsed;
    RC_ASSERT(due.ticks_elapsed >= 1u);
    RC_ASSERT(due.tick == elapsed);
    RC_ASSERT(schedule.deadline(due.tick) <= now && now < schedule.deadline(due.tick + 1));
    RC_ASSERT(schedule.missed() == elapsed - static_cast<std::uint64_t>(i + 1));
  }
}

RC_GTEST_PROP(DurationHistogram, QuantilesAreWithinTwoPercentOfTheSortedValues, ()) {
  const auto values = *rc::gen::nonEmpty(
      rc::gen::container<std::vector<std::int64_t>>(rc::gen::inRange<std::int64_t>(0, 5'000'000'000)));
  DurationHistogram histogram;
  for (const std::int64_t v : values) histogram.add(v);
  std::vector<std::int64_t> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  for (const double q : {0.0, 0.5, 0.99, 1.0}) {
    const auto rank =
        std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(q * static_cast<double>(sorted.size()))));
    const auto truth = static_cast<double>(sorted[rank - 1]);
    const auto found = static_cast<double>(histogram.quantile(q));
    RC_ASSERT(found >= truth && found <= truth * (1.0 + 1.0 / 64.0));
  }
  RC_ASSERT(histogram.max() == sorted.back());
  RC_ASSERT(histogram.count() == sorted.size());
}

TEST(DurationHistogram, HoldsExtremes) {
  DurationHistogram histogram;
  EXPECT_EQ(histogram.quantile(0.5), 0);
  histogram.add(-5);
  EXPECT_EQ(histogram.max(), 0);
  histogram.add(std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(histogram.quantile(1.0), std::numeric_limits<std::int64_t>::max());
}

// The thread itself, at a period so short that the test takes no time; nothing is asserted about how long
// anything takes.

TEST(SamplingThread, CallsBackOncePerTickInOrderUntilToldToEnd) {
  std::vector<SamplingTick> ticks;
  SamplingThread thread(100'000, [&](const SamplingTick& tick) {
    ticks.push_back(tick);
    return ticks.size() < 50;
  });
  thread.join();
  ASSERT_EQ(ticks.size(), 50u);
  std::uint64_t elapsed = 0;
  for (const SamplingTick& t : ticks) {
    elapsed += t.ticks_elapsed;
    EXPECT_EQ(t.tick, elapsed);
    EXPECT_EQ(t.elapsed_ns, static_cast<std::int64_t>(t.tick) * 100'000);
  }
  EXPECT_FALSE(thread.running());
  EXPECT_EQ(thread.jitter().lateness.count(), 50u);
  EXPECT_EQ(thread.jitter().period.count(), 49u);
  EXPECT_EQ(thread.jitter().deviation.count(), 49u);
  EXPECT_EQ(thread.jitter().missed.load(), elapsed - 50);
}

TEST(SamplingThread, NeverCallsBeforeTheDeadline) {
  const std::int64_t before_start = MonotonicClock().nowNs();
  std::int64_t earliest = std::numeric_limits<std::int64_t>::max();
  int calls = 0;
  SamplingThread thread(200'000, [&](const SamplingTick& t) {
    earliest = std::min(earliest, t.now_ns - t.elapsed_ns);
    return ++calls < 30;
  });
  thread.join();
  EXPECT_GE(earliest, before_start);
}

TEST(SamplingThread, StopEndsARunThatWouldNotEnd) {
  SamplingThread thread(100'000, [](const SamplingTick&) { return true; });
  thread.stop();
  thread.join();
  EXPECT_FALSE(thread.running());
}

TEST(SamplingThread, WhatTheCallbackThrowsComesOutOfJoin) {
  SamplingThread thread(100'000,
                        [](const SamplingTick&) -> bool { throw std::runtime_error("the master broke"); });
  EXPECT_THROW(thread.join(), std::runtime_error);
  EXPECT_FALSE(thread.running());
  EXPECT_NO_THROW(thread.join());
}

}  // namespace
}  // namespace coherency
