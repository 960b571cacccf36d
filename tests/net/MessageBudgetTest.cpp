#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "motion_server/broadcast/MessageBudget.h"

namespace coherency {
namespace {

TEST(MessageBudget, GivesTheBurstAndThenTheRate) {
  MessageBudget budget(10, 5, ServerTime{0});
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(budget.take({0}));
  EXPECT_FALSE(budget.take({0}));
  EXPECT_FALSE(budget.take({99'999'999}));
  EXPECT_TRUE(budget.take({100'000'000}));
  EXPECT_FALSE(budget.take({100'000'000}));
}

RC_GTEST_PROP(MessageBudget, NeverGivesMoreThanRateAndBurst, ()) {
  const auto rate = *rc::gen::inRange<std::int64_t>(1, 1000);
  const auto burst = *rc::gen::inRange<std::int64_t>(1, 100);
  MessageBudget budget(rate, burst, ServerTime{0});
  ServerTime now{0};
  std::int64_t taken = 0;
  for (int i = 0; i < 500; ++i) {
    now = now + *rc::gen::inRange<std::int64_t>(0, 3'000'000'000 / rate);
    taken += budget.take(now) ? 1 : 0;
    const std::int64_t interval = 1'000'000'000 / rate;
    RC_ASSERT(taken <= now.ns / interval + burst);
  }
}

}  // namespace
}  // namespace coherency
