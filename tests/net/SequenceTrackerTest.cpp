#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "render_client/receive/SequenceTracker.h"

namespace coherency {
namespace {

using Arrival = SequenceTracker::Arrival;

std::vector<MotionSample> before(std::uint64_t sequence, int redundancy) {
  std::vector<MotionSample> previous;
  for (int i = 1; i <= redundancy && sequence > static_cast<std::uint64_t>(i); ++i) {
    MotionSample sample;
    sample.sequence = sequence - static_cast<std::uint64_t>(i);
    previous.push_back(sample);
  }
  return previous;
}

TEST(SequenceTracker, InOrderNothingIsLost) {
  SequenceTracker tracker;
  for (std::uint64_t s = 500; s < 10'500; ++s) EXPECT_EQ(tracker.add(s, before(s, 2)), Arrival::Newest);
  EXPECT_EQ(tracker.counts().received, 10'000U);
  EXPECT_EQ(tracker.counts().lost, 0U);
  EXPECT_EQ(tracker.counts().recovered, 0U);
  EXPECT_EQ(tracker.counts().reordered, 0U);
}

TEST(SequenceTracker, AGapIsLostAndWhatALaterPacketBringsIsRecovered) {
  SequenceTracker tracker;
  tracker.add(1, {});
  tracker.add(5, before(5, 2));  // 2, 3, 4 are missing; 3 and 4 are in this one
  EXPECT_EQ(tracker.counts().lost, 3U);
  EXPECT_EQ(tracker.counts().recovered, 2U);
  tracker.add(6, before(6, 5));  // brings 2 as well
  EXPECT_EQ(tracker.counts().recovered, 3U);
}

TEST(SequenceTracker, ALatePacketIsNoLongerLost) {
  SequenceTracker tracker;
  tracker.add(1, {});
  tracker.add(3, before(3, 2));
  EXPECT_EQ(tracker.add(2, before(2, 2)), Arrival::Late);
  EXPECT_EQ(tracker.counts().lost, 0U);
  EXPECT_EQ(tracker.counts().recovered, 0U);
  EXPECT_EQ(tracker.counts().reordered, 1U);
  EXPECT_EQ(tracker.add(2, before(2, 2)), Arrival::Again);
  EXPECT_EQ(tracker.counts().reordered, 2U);
}

TEST(SequenceTracker, BeforeTheFirstNothingWasOurs) {
  SequenceTracker tracker;
  tracker.add(100, before(100, 2));
  EXPECT_EQ(tracker.add(99, before(99, 2)), Arrival::Late);
  EXPECT_EQ(tracker.counts().lost, 0U);
}

TEST(SequenceTracker, RestartForgivesTheGapAndKeepsTheCounts) {
  SequenceTracker tracker;
  tracker.add(1, {});
  tracker.add(3, {});
  tracker.restart();
  EXPECT_EQ(tracker.add(1'000'000, before(1'000'000, 2)), Arrival::Newest);
  EXPECT_EQ(tracker.counts().lost, 1U);
  tracker.restart();
  EXPECT_EQ(tracker.add(1, {}), Arrival::Newest);  // of another session
  EXPECT_EQ(tracker.counts().received, 4U);
}

TEST(SequenceTracker, AHugeJumpIsCountedWithoutWalkingIt) {
  SequenceTracker tracker;
  tracker.add(1, {});
  tracker.add(~std::uint64_t{0}, before(~std::uint64_t{0}, 2));
  EXPECT_EQ(tracker.counts().lost, ~std::uint64_t{0} - 2);
  EXPECT_EQ(tracker.counts().recovered, 2U);
}

// Any loss, any order within the window: the account agrees with one that remembers everything.
RC_GTEST_PROP(SequenceTracker, AgreesWithAFullAccount, ()) {
  const int redundancy = *rc::gen::inRange(0, 4);
  SequenceTracker tracker;
  std::set<std::uint64_t> came;
  std::set<std::uint64_t> within;
  std::uint64_t next = *rc::gen::inRange<std::uint64_t>(1, 1000);
  const std::uint64_t first = next;
  tracker.add(next, before(next, redundancy));
  came.insert(next);
  const int packets = *rc::gen::inRange(1, 300);
  std::uint64_t late = 0;
  for (int i = 0; i < packets; ++i) {
    const bool is_late = *rc::gen::inRange(0, 5) == 0;
    const std::uint64_t newest = *came.rbegin();
    const std::uint64_t sequence =
        is_late ? *rc::gen::inRange(first, newest + 1) : newest + *rc::gen::inRange<std::uint64_t>(1, 6);
    const auto previous = before(sequence, redundancy);
    const bool again = came.count(sequence) != 0;
    const Arrival expected = sequence > newest ? Arrival::Newest : again ? Arrival::Again : Arrival::Late;
    RC_ASSERT(tracker.add(sequence, previous) == expected);
    if (expected != Arrival::Newest) ++late;
    came.insert(sequence);
    for (const MotionSample& sample : previous) within.insert(sample.sequence);
  }
  std::uint64_t lost = 0;
  std::uint64_t recovered = 0;
  for (std::uint64_t s = first; s < *came.rbegin(); ++s) {
    if (came.count(s) != 0) continue;
    ++lost;
    recovered += within.count(s);
  }
  RC_ASSERT(tracker.counts().lost == lost);
  RC_ASSERT(tracker.counts().recovered == recovered);
  RC_ASSERT(tracker.counts().reordered == late);
  RC_ASSERT(tracker.counts().received == static_cast<std::uint64_t>(packets) + 1);
}

}  // namespace
}  // namespace coherency
