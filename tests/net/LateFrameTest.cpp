#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "render_client/receive/FrameBuffer.h"

namespace coherency {
namespace {

constexpr std::int64_t kFrameNs = 16;

/// Seen at its number's moment.
ReceivedFrame frame(std::uint64_t number) {
  ReceivedFrame received{};
  received.state.number = number;
  received.state.sample.server_time_ns = static_cast<std::int64_t>(number) * kFrameNs;
  return received;
}

std::uint64_t drawnAfter(std::uint64_t after, std::int64_t now_ns, std::int64_t draw_ns,
                         const FrameBuffer& buffer) {
  const auto next = buffer.next(after, 1, {now_ns + draw_ns}, draw_ns);
  return next ? next->state.number : 0;
}

TEST(LateFrameTest, IsDrawnWhereTheNextStillComesInTime) {
  FrameBuffer buffer;
  for (const std::uint64_t number : {10, 11}) buffer.add(frame(number));  // seen at 160 and 176
  EXPECT_EQ(drawnAfter(9, 154, 6, buffer), 10U) << "in time";
  EXPECT_EQ(drawnAfter(9, 155, 6, buffer), 10U) << "late by 1";
  EXPECT_EQ(drawnAfter(9, 164, 6, buffer), 10U) << "its own picture and the next take until 176";
  EXPECT_EQ(drawnAfter(9, 165, 6, buffer), 11U) << "the next would be late";
  EXPECT_EQ(drawnAfter(10, 165, 6, buffer), 11U);
}

TEST(LateFrameTest, OnlyTheNewestIsEverDrawnLate) {
  FrameBuffer buffer;
  for (std::uint64_t number = 10; number <= 14; ++number) buffer.add(frame(number));
  EXPECT_EQ(drawnAfter(9, 203, 2, buffer), 12U) << "10 to 12 are late, 13 is seen at 208";
  EXPECT_EQ(drawnAfter(9, 1000, 2, buffer), 14U) << "all are";
}

RC_GTEST_PROP(LateFrameTest, IsTheOneBeforeTheFirstInTimeOrNone, ()) {
  const auto numbers = *rc::gen::container<std::set<std::uint64_t>>(rc::gen::inRange<std::uint64_t>(1, 60));
  const auto draw_ns = *rc::gen::inRange<std::int64_t>(0, 2 * kFrameNs);
  const auto now_ns = *rc::gen::inRange<std::int64_t>(0, 60 * kFrameNs);
  RC_PRE(!numbers.empty());
  FrameBuffer buffer;
  for (const std::uint64_t number : numbers) buffer.add(frame(number));
  const auto spare = [&](std::uint64_t number) {
    return static_cast<std::int64_t>(number) * kFrameNs - now_ns - draw_ns;
  };
  const std::uint64_t drawn = drawnAfter(0, now_ns, draw_ns, buffer);
  const auto in_time =
      std::find_if(numbers.begin(), numbers.end(), [&](std::uint64_t n) { return spare(n) >= 0; });
  if (in_time == numbers.end() || (in_time != numbers.begin() && spare(*in_time) >= draw_ns))
    RC_ASSERT(drawn == *std::prev(in_time));
  else
    RC_ASSERT(drawn == *in_time);
}

}  // namespace
}  // namespace coherency
