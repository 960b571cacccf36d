#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/ReplayWindow.h"

namespace coherency {
namespace {

/// What the window is to be, remembering everything.
class Everything {
 public:
  bool fresh(std::uint64_t counter) const {
    if (counter == 0 || taken_.contains(counter)) return false;
    return taken_.empty() || counter > *taken_.rbegin() || *taken_.rbegin() - counter < kReplayWindow;
  }
  void take(std::uint64_t counter) { taken_.insert(counter); }
  std::uint64_t highest() const { return taken_.empty() ? 0 : *taken_.rbegin(); }

 private:
  std::set<std::uint64_t> taken_;
};

/// A counter where mistakes would be: around the highest, around the window's end, around words' borders, and
/// anywhere.
std::uint64_t nextCounter(std::uint64_t highest) {
  const auto near = *rc::gen::inRange<std::int64_t>(-70, 71);
  const auto about = [&](std::uint64_t place) { return place + static_cast<std::uint64_t>(near); };
  switch (*rc::gen::inRange(0, 7)) {
    case 0:
      return about(highest - kReplayWindow);
    case 1:
      return about(highest + kReplayWindow);
    case 2:
      return highest - *rc::gen::inRange<std::uint64_t>(0, 2 * kReplayWindow);
    case 3:
      return highest + *rc::gen::inRange<std::uint64_t>(0, 3 * kReplayWindow);
    case 4:
      return *rc::gen::arbitrary<std::uint64_t>();
    default:
      return about(highest);
  }
}

RC_GTEST_PROP(ReplayWindow, IsAMemoryOfEverythingCutAtItsLength, ()) {
  ReplayWindow window;
  Everything model;
  // From the beginning, and from where counters end too.
  if (*rc::gen::arbitrary<bool>()) {
    const std::uint64_t start = std::numeric_limits<std::uint64_t>::max() - *rc::gen::inRange(0U, 20'000U);
    window.take(start);
    model.take(start);
  }
  for (int i = 0; i < 300; ++i) {
    const std::uint64_t counter = nextCounter(model.highest());
    RC_ASSERT(window.fresh(counter) == model.fresh(counter));
    if (!model.fresh(counter)) continue;
    window.take(counter);
    model.take(counter);
    RC_ASSERT(!window.fresh(counter));
  }
  for (std::uint64_t age = 0; age < kReplayWindow + 200; ++age) {
    const std::uint64_t counter = model.highest() - age;
    RC_ASSERT(window.fresh(counter) == model.fresh(counter));
  }
}

RC_GTEST_PROP(ReplayWindow, EachPassesOnceInAnyOrderWithinTheWindow, ()) {
  const auto first = *rc::gen::inRange<std::uint64_t>(1, 1'000'000);
  std::vector<std::uint64_t> counters(kReplayWindow);
  for (std::size_t i = 0; i < counters.size(); ++i) counters[i] = first + i;
  std::shuffle(counters.begin(), counters.end(), std::mt19937_64(*rc::gen::arbitrary<std::uint64_t>()));
  ReplayWindow window;
  for (const std::uint64_t counter : counters) {
    RC_ASSERT(window.fresh(counter));
    window.take(counter);
  }
  for (const std::uint64_t counter : counters) RC_ASSERT(!window.fresh(counter));
}

TEST(ReplayWindow, CountersBeginAtOne) {
  const ReplayWindow window;
  EXPECT_FALSE(window.fresh(0));
  EXPECT_TRUE(window.fresh(1));
  EXPECT_TRUE(window.fresh(std::numeric_limits<std::uint64_t>::max()));
}

TEST(ReplayWindow, EndsWhereItSays) {
  // Wherever the highest lies in its word.
  for (std::uint64_t highest = 2 * kReplayWindow; highest < 2 * kReplayWindow + 64; ++highest) {
    ReplayWindow window;
    window.take(highest);
    EXPECT_TRUE(window.fresh(highest - kReplayWindow + 1)) << highest;
    EXPECT_FALSE(window.fresh(highest - kReplayWindow)) << highest;
  }
}

TEST(ReplayWindow, AJumpForgetsNothingThatCounts) {
  ReplayWindow window;
  for (std::uint64_t counter = 1; counter <= 5000; ++counter) window.take(counter);
  window.take(5000 + kReplayWindow - 1);
  EXPECT_FALSE(window.fresh(5000));
  EXPECT_TRUE(window.fresh(5001));
  window.take(std::uint64_t{1} << 63);
  EXPECT_FALSE(window.fresh(5001));
  EXPECT_TRUE(window.fresh((std::uint64_t{1} << 63) - 1));
}

}  // namespace
}  // namespace coherency
