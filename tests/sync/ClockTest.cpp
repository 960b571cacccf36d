#include <functional>
#include <type_traits>

#include <gtest/gtest.h>

#include "common/sync/Clock.h"

namespace coherency {
namespace {

TEST(Clock, ManualStandsStillUntilTold) {
  ManualClock clock;
  EXPECT_EQ(clock.nowNs(), 0);
  clock.advance(250);
  clock.advance(-50);
  EXPECT_EQ(clock.nowNs(), 200);
}

TEST(Clock, MonotonicNeverGoesBack) {
  const MonotonicClock clock;
  std::int64_t last = clock.nowNs();
  for (int i = 0; i < 10'000; ++i) {
    const std::int64_t now = clock.nowNs();
    ASSERT_GE(now, last);
    last = now;
  }
}

TEST(Clock, TimesOfTwoClocksDoNotMix) {
  static_assert(!std::is_convertible_v<ServerTime, ClientTime>);
  static_assert(!std::is_invocable_v<std::minus<>, ServerTime, ClientTime>);
  EXPECT_EQ(ServerTime{7} - ServerTime{5}, 2);
  EXPECT_EQ(ServerTime{7} + 5, ServerTime{12});
  EXPECT_LT(ClientTime{1}, ClientTime{2});
}

}  // namespace
}  // namespace coherency
