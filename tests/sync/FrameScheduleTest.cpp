#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/sync/FrameSchedule.h"

namespace coherency {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kSlackNs = kMs / 2;  // the schedule's, above what eyes have needed

FrameScheduleConfig config() {
  return {16 * kMs, 2 * kMs, 100 * kMs};
}

class FrameScheduleTest : public ::testing::Test {
 protected:
  /// Fills all that the schedule remembers.
  void hear(std::int64_t ready_ns, std::int64_t draw_ns, std::size_t times = FrameSchedule::kNeeds) {
    for (std::size_t i = 0; i < times; ++i) schedule_.heard({ready_ns, draw_ns});
  }
  FrameSchedule::Due next() {
    frame_ += static_cast<std::int64_t>(schedule_.stride());
    const auto due = schedule_.take(frame_ * config().frame_ns);
    EXPECT_TRUE(due);
    return due.value_or(FrameSchedule::Due{});
  }
  /// The margin once it has had time to go where it is wanted.
  std::int64_t settled() {
    for (int i = 0; i < 20'000; ++i) next();
    return schedule_.marginNs();
  }

  FrameSchedule schedule_{config()};
  std::int64_t frame_ = 0;
};

// ---- Which frame ----

TEST_F(FrameScheduleTest, TheFirstFrameIsTheFirstAndAFrameAhead) {
  EXPECT_FALSE(schedule_.take(0));
  EXPECT_FALSE(schedule_.take(16 * kMs - 1));
  const auto due = schedule_.take(16 * kMs);
  ASSERT_TRUE(due);
  EXPECT_EQ(due->number, 1U);
  EXPECT_EQ(due->moment_ns, 16 * kMs);
  EXPECT_EQ(due->margin_ns, 16 * kMs) << "before anything was heard: a frame";
  EXPECT_FALSE(schedule_.take(16 * kMs)) << "each is given out once";
}

TEST_F(FrameScheduleTest, TheFirstMarginIsWithinItsBounds) {
  EXPECT_EQ(FrameSchedule({16 * kMs, 20 * kMs, 100 * kMs}).marginNs(), 20 * kMs);
  EXPECT_EQ(FrameSchedule({16 * kMs, 2 * kMs, 10 * kMs}).marginNs(), 10 * kMs);
  EXPECT_EQ(FrameSchedule({16 * kMs, 0, 0}).marginNs(), 0);
}

TEST_F(FrameScheduleTest, AfterMissedTicksTheNewestIsDue) {
  EXPECT_EQ(schedule_.take(5 * 16 * kMs + 7 * kMs)->number, 5U);
  EXPECT_FALSE(schedule_.take(5 * 16 * kMs + 15 * kMs));
  EXPECT_EQ(schedule_.take(6 * 16 * kMs)->number, 6U);
}

TEST_F(FrameScheduleTest, WhereAFrameIsNoWholeNumberOfTicksNoneIsMissed) {
  for (const std::int64_t frame_ns : {16'666'667, 11'111'111, 1'000'000, 2'777'778}) {
    FrameSchedule schedule({frame_ns, 2 * kMs, 100 * kMs});
    std::uint64_t last = 0;
    for (std::int64_t tick = 1; tick <= 60'000; ++tick) {
      const auto due = schedule.take(tick * kMs);
      if (!due) continue;
      ASSERT_EQ(due->number, last + 1);
      ASSERT_EQ(due->moment_ns, static_cast<std::int64_t>(due->number) * frame_ns);
      ASSERT_LE(due->moment_ns, tick * kMs);
      ASSERT_GT(due->moment_ns, (tick - 1) * kMs) << "at the first tick that is not before it";
      last = due->number;
    }
    EXPECT_EQ(last, static_cast<std::uint64_t>(60'000 * kMs / frame_ns));
  }
}

// Whatever the ticks and the needs: numbers rise, none is before its moment, margins stay in bounds and slew.
RC_GTEST_PROP(FrameSchedule, IsMonotonicAndSlews, ()) {
  FrameSchedule schedule(config());
  std::int64_t elapsed = 0;
  FrameSchedule::Due last{0, 0, schedule.marginNs()};
  for (int i = 0; i < 200; ++i) {
    elapsed += *rc::gen::inRange<std::int64_t>(0, 60 * kMs);
    const auto needs = *rc::gen::inRange(0, 40);
    const FrameNeed need{*rc::gen::inRange<std::int64_t>(-50 * kMs, 300 * kMs),
                         *rc::gen::inRange<std::int64_t>(0, 200 * kMs)};
    for (int k = 0; k < needs; ++k) schedule.heard(need);
    const std::uint64_t stride = schedule.stride();
    RC_ASSERT(stride >= 1 && stride <= FrameSchedule::kMostStride);
    const auto due = schedule.take(elapsed);
    if (!due) continue;
    RC_ASSERT(due->number > last.number);
    RC_ASSERT(due->number % stride == 0);
    RC_ASSERT(due->moment_ns == static_cast<std::int64_t>(due->number) * config().frame_ns);
    RC_ASSERT(due->moment_ns <= elapsed);
    RC_ASSERT(due->margin_ns >= config().least_margin_ns && due->margin_ns <= config().most_margin_ns);
    RC_ASSERT(due->margin_ns - last.margin_ns <= kMs);
    RC_ASSERT(last.margin_ns - due->margin_ns <= (due->moment_ns - last.moment_ns) / 1000);
    RC_ASSERT(due->moment_ns + due->margin_ns > last.moment_ns + last.margin_ns);
    last = *due;
  }
}

// ---- The margin ----

TEST_F(FrameScheduleTest, TheMarginIsWhatArrivalAndDrawingNeedAndALittle) {
  hear(5 * kMs, 7 * kMs);
  EXPECT_EQ(settled(), 12 * kMs + kSlackNs);
  hear(1 * kMs, 30 * kMs);  // is slower to draw than frames follow each other, too
  EXPECT_EQ(settled(), 31 * kMs + kSlackNs);
}

TEST_F(FrameScheduleTest, OneOfAThousandMayComeTooLate) {
  hear(5 * kMs, 7 * kMs, FrameSchedule::kNeeds - 2);
  hear(70 * kMs, 7 * kMs, 2);
  EXPECT_EQ(settled(), 12 * kMs + kSlackNs);
  hear(5 * kMs, 7 * kMs, FrameSchedule::kNeeds - 3);
  hear(70 * kMs, 7 * kMs, 3);
  EXPECT_EQ(settled(), 77 * kMs + kSlackNs);
}

TEST_F(FrameScheduleTest, WhatIsLongPastIsForgotten) {
  hear(70 * kMs, 7 * kMs, 128);
  EXPECT_EQ(settled(), 77 * kMs + kSlackNs);
  hear(5 * kMs, 7 * kMs, FrameSchedule::kNeeds);
  EXPECT_EQ(settled(), 12 * kMs + kSlackNs);
}

TEST_F(FrameScheduleTest, AFewNeedsAreNotYetHeeded) {
  hear(5 * kMs, 7 * kMs, 31);
  EXPECT_EQ(settled(), 16 * kMs);
  hear(5 * kMs, 7 * kMs, 1);
  EXPECT_EQ(settled(), 12 * kMs + kSlackNs);
}

TEST_F(FrameScheduleTest, TheMarginKeepsItsBounds) {
  hear(500 * kMs, 7 * kMs);
  EXPECT_EQ(settled(), 100 * kMs);
  hear(-500 * kMs, 7 * kMs);  // before its moment: clocks that are off, or worse
  EXPECT_EQ(settled(), 2 * kMs);
}

TEST_F(FrameScheduleTest, GrowsByAMillisecondAFrame) {
  next();
  hear(40 * kMs, 9 * kMs + kSlackNs);  // 50 ms are wanted, 16 there
  for (std::int64_t margin = 17; margin <= 50; ++margin) EXPECT_EQ(next().margin_ns, margin * kMs);
  EXPECT_EQ(next().margin_ns, 50 * kMs);
}

TEST_F(FrameScheduleTest, ShrinksByAMillisecondASecondHoweverFramesCome) {
  next();
  hear(3 * kMs, 5 * kMs + kSlackNs);  // 9 ms are wanted, 16 there
  const auto margin_after = [&](std::int64_t frames) {
    frame_ += frames;
    return schedule_.take(frame_ * config().frame_ns)->margin_ns;
  };
  EXPECT_EQ(margin_after(1), 16 * kMs - 16'000);
  EXPECT_EQ(margin_after(3), 16 * kMs - 4 * 16'000) << "missed frames are time as well";
  for (std::int64_t i = 5; i <= 125; ++i) next();
  EXPECT_EQ(schedule_.marginNs(), 14 * kMs) << "after two seconds";
  EXPECT_GE(margin_after(1'000'000), 13 * kMs) << "a long pause is no leap";
  EXPECT_EQ(settled(), 9 * kMs);
}

// ---- The stride ----

TEST_F(FrameScheduleTest, SlowDrawingLeavesOutEverySecondFrameAndSoOn) {
  const auto strideAt = [](std::int64_t draw_ns) {
    FrameSchedule schedule(config());
    for (std::size_t i = 0; i < FrameSchedule::kNeeds; ++i) schedule.heard({0, draw_ns});
    return schedule.stride();
  };
  EXPECT_EQ(strideAt(0), 1U);
  EXPECT_EQ(strideAt(15 * kMs), 1U);
  EXPECT_EQ(strideAt(16 * kMs), 2U) << "with nothing left between frames";
  EXPECT_EQ(strideAt(29 * kMs), 2U);
  EXPECT_EQ(strideAt(40 * kMs), 3U);
  EXPECT_EQ(strideAt(10'000 * kMs), FrameSchedule::kMostStride);
}

TEST_F(FrameScheduleTest, ADrawingTimeOnTheBorderDoesNotSwitchToAndFro) {
  hear(0, 14 * kMs);
  EXPECT_EQ(schedule_.stride(), 1U);
  hear(0, 16 * kMs);
  EXPECT_EQ(schedule_.stride(), 2U);
  hear(0, 14 * kMs);
  EXPECT_EQ(schedule_.stride(), 2U) << "as long as it would hardly fit";
  hear(0, 12 * kMs);
  EXPECT_EQ(schedule_.stride(), 1U);
}

TEST_F(FrameScheduleTest, AFewSlowPicturesChangeNoStride) {
  hear(0, 8 * kMs);
  hear(0, 50 * kMs, FrameSchedule::kNeeds / 10 - 8);
  EXPECT_EQ(schedule_.stride(), 1U);
  hear(0, 50 * kMs, 40);
  EXPECT_EQ(schedule_.stride(), 4U);
}

TEST_F(FrameScheduleTest, FramesAreMultiplesOfTheStrideAndGoOnRisingWhenItEnds) {
  EXPECT_EQ(schedule_.take(5 * 16 * kMs)->number, 5U);
  hear(0, 40 * kMs);  // stride 3
  EXPECT_EQ(schedule_.take(6 * 16 * kMs)->number, 6U);
  EXPECT_FALSE(schedule_.take(7 * 16 * kMs));
  EXPECT_FALSE(schedule_.take(8 * 16 * kMs));
  EXPECT_EQ(schedule_.take(9 * 16 * kMs)->number, 9U);
  hear(0, 5 * kMs);
  EXPECT_FALSE(schedule_.take(9 * 16 * kMs));
  EXPECT_EQ(schedule_.take(10 * 16 * kMs)->number, 10U);
}

TEST_F(FrameScheduleTest, WhoHasGoneHoldsNobodyBack) {
  FrameSchedule schedule(FrameScheduleConfig{});
  for (int i = 0; i < 500; ++i) schedule.heard({2'000'000, 60'000'000, i * std::int64_t{16'000'000}});
  EXPECT_GT(schedule.stride(), 1U);
  const std::int64_t later = 500 * std::int64_t{16'000'000} + FrameSchedule::kMemoryNs;
  for (int i = 0; i < 32; ++i) schedule.heard({2'000'000, 3'000'000, later + i * std::int64_t{16'000'000}});
  EXPECT_EQ(schedule.stride(), 1U);
}

}  // namespace
}  // namespace coherency
