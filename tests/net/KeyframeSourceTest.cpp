#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "motion_server/broadcast/KeyframeSource.h"
#include "tests/net/Support.h"

namespace coherency {
namespace {

using testing::worldAt;

class KeyframeSourceTest : public ::testing::Test {
 protected:
  std::uint32_t current() { return source_.current(world_, now_).number; }
  std::vector<std::uint32_t> needed() const {
    std::vector<std::uint32_t> numbers;
    for (const Keyframe& keyframe : source_.needed()) numbers.push_back(keyframe.number);
    return numbers;
  }
  /// A second keyframe is there and not yet counted from.
  void makeSecond() {
    current();
    world_.movables[0].x_nm = 7;
    now_ = now_ + KeyframeSource::kEveryNs;
    EXPECT_EQ(current(), 1U);
  }

  KeyframeSource source_;
  WorldState world_ = worldAt(1);
  ServerTime now_{5'000'000'000};
};

using Numbers = std::vector<std::uint32_t>;

TEST_F(KeyframeSourceTest, TheFirstIsTheFirstState) {
  EXPECT_EQ(source_.newest(), 0U);
  EXPECT_TRUE(source_.needed().empty());
  EXPECT_EQ(source_.current(world_, now_), (Keyframe{1, world_}));
  EXPECT_EQ(source_.newest(), 1U);
  EXPECT_EQ(needed(), Numbers{1});
}

TEST_F(KeyframeSourceTest, WhatOnlyDrivesNeedsNoNewOne) {
  current();
  for (int i = 0; i < 100; ++i) {
    now_ = now_ + KeyframeSource::kEveryNs;
    ++world_.tick;
    world_.master.base.x_nm += 1'000'000;
    world_.closed_hands ^= 1;
    EXPECT_EQ(current(), 1U);
  }
  EXPECT_EQ(source_.newest(), 1U);
}

TEST_F(KeyframeSourceTest, MovablesDoorsAndTheTaskDoSomeSecondsAfterTheLast) {
  const std::vector<std::function<void(WorldState&)>> changes = {
      [](WorldState& w) { w.movables[0].resting = false; }, [](WorldState& w) { w.doors[0] = 5; },
      [](WorldState& w) { w.task.towers = 1; }};
  for (const auto& change : changes) {
    KeyframeSource source;
    WorldState world = worldAt(1);
    source.current(world, now_);
    change(world);
    source.current(world, now_ + (KeyframeSource::kEveryNs - 1));
    EXPECT_EQ(source.newest(), 1U);
    source.current(world, now_ + KeyframeSource::kEveryNs);
    EXPECT_EQ(source.newest(), 2U);
    EXPECT_EQ(source.needed().at(1), (Keyframe{2, world}));
  }
}

TEST_F(KeyframeSourceTest, IsCountedFromWhenAllHaveIt) {
  makeSecond();
  EXPECT_EQ(needed(), (Numbers{1, 2}));
  source_.allHave(1);
  EXPECT_EQ(current(), 1U);
  source_.allHave(2);
  EXPECT_EQ(current(), 2U);
  EXPECT_EQ(needed(), Numbers{2});
}

TEST_F(KeyframeSourceTest, WhoNeverAcknowledgesHoldsNobodyBackForLong) {
  makeSecond();
  source_.allHave(0);
  now_ = now_ + (KeyframeSource::kPatienceNs - 1);
  EXPECT_EQ(current(), 1U);
  now_ = now_ + 1;
  EXPECT_EQ(current(), 2U);
}

TEST_F(KeyframeSourceTest, WhereNobodyIsThereItServesAtOnce) {
  makeSecond();
  source_.allHave(~std::uint32_t{0});
  EXPECT_EQ(current(), 2U);
}

// Nobody was there a moment ago: since then somebody may have come.
TEST_F(KeyframeSourceTest, WhatWasHeardBeforeItWasMadeDoesNotCount) {
  current();
  source_.allHave(~std::uint32_t{0});
  makeSecond();
  now_ = now_ + 1'000'000;
  EXPECT_EQ(current(), 1U);
}

TEST_F(KeyframeSourceTest, HasNeverMoreThanTwoAndThePromisedOneDoesNotChange) {
  makeSecond();
  const Keyframe promised = source_.needed().at(1);
  for (int i = 0; i < 10; ++i) {
    ++world_.movables[0].x_nm;
    now_ = now_ + KeyframeSource::kPatienceNs / 20;
    current();
    EXPECT_EQ(source_.needed().at(1), promised);
    EXPECT_EQ(source_.newest(), 2U);
  }
}

}  // namespace
}  // namespace coherency
