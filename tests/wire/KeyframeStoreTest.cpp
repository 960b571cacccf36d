#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/KeyframeStore.h"
#include "tests/wire/Generators.h"

namespace coherency {
namespace {

Keyframe numbered(std::uint32_t number) {
  Keyframe keyframe{number, {}};
  keyframe.world.tick = 10 * std::uint64_t{number};
  keyframe.world.movables.resize(2);
  keyframe.world.doors.resize(2);
  return keyframe;
}

TEST(KeyframeStore, IsEmptyAtFirstAndWhenCleared) {
  KeyframeStore store;
  EXPECT_EQ(store.newest(), 0U);
  EXPECT_EQ(store.find(0), nullptr);
  EXPECT_EQ(store.find(1), nullptr);
  store.add(numbered(1));
  ASSERT_NE(store.find(1), nullptr);
  EXPECT_EQ(store.find(0), nullptr) << "what is not taken yet is no keyframe 0";
  store.clear();
  EXPECT_EQ(store.newest(), 0U);
  EXPECT_EQ(store.find(1), nullptr);
  EXPECT_EQ(store.find(0), nullptr);
}

RC_GTEST_PROP(KeyframeStore, KeepsTheTwoNewestInWhateverOrderTheyCome, ()) {
  const auto numbers = *rc::gen::nonEmpty(
      rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(1, 12)));
  KeyframeStore store;
  for (const std::uint32_t number : numbers) RC_ASSERT(store.add(numbered(number)) == std::nullopt);
  auto rising = numbers;
  std::sort(rising.begin(), rising.end());
  rising.erase(std::unique(rising.begin(), rising.end()), rising.end());
  const std::size_t kept_from = rising.size() - std::min<std::size_t>(2, rising.size());
  for (std::size_t i = 0; i < rising.size(); ++i) {
    const WorldState* const found = store.find(rising[i]);
    RC_ASSERT((found != nullptr) == (i >= kept_from));
    if (found != nullptr) RC_ASSERT(*found == numbered(rising[i]).world);
  }
  RC_ASSERT(store.newest() == rising.back());
}

TEST(KeyframeStore, AChangedOneTakesItsPlaceAndNamesWhereItDiffersFirst) {
  KeyframeStore store;
  store.add(numbered(1));
  store.add(numbered(2));
  const auto changed = [&](auto change) {
    Keyframe keyframe = numbered(1);
    change(keyframe.world);
    store.add(numbered(1));
    const auto name = store.add(keyframe);
    EXPECT_EQ(*store.find(1), keyframe.world);
    EXPECT_EQ(*store.find(2), numbered(2).world) << "the other one is left alone";
    return name.value_or("nothing");
  };
  EXPECT_EQ(changed([](WorldState&) {}), "nothing");
  EXPECT_EQ(changed([](WorldState& w) { w.mode = Mode::Robot; }), "mode");
  EXPECT_EQ(changed([](WorldState& w) { w.master.base.heading_units = 1; }), "heading");
  EXPECT_EQ(changed([](WorldState& w) { w.doors[1] = w.movables[1].fall_um = 5; }), "fall");
  EXPECT_EQ(changed([](WorldState& w) { w.doors[1] = 5; }), "door");
  EXPECT_EQ(changed([](WorldState& w) { w.movables.pop_back(); }), "number of movables");
  EXPECT_EQ(changed([](WorldState& w) { w.doors.pop_back(); }), "number of doors");
  EXPECT_EQ(changed([](WorldState& w) { w.task.standing = true; }), "tower stands");
}

RC_GTEST_PROP(FirstDifference, IsNoneExactlyWhereStatesAreEqual, ()) {
  const WorldState a = random::state();
  RC_ASSERT(firstDifference(a, a) == std::nullopt);
  const WorldState b = arbitrary::changed(a);
  RC_ASSERT(firstDifference(a, b).has_value() == !(a == b));
  RC_ASSERT(firstDifference(a, b) == firstDifference(b, a));
}

}  // namespace
}  // namespace coherency
