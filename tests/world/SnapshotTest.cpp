#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/world/Snapshot.h"
#include "tests/world/Generators.h"

namespace coherency {
namespace {

std::string refusal(const std::vector<std::byte>& bytes) {
  try {
    restore(bytes);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

RC_GTEST_PROP(Snapshot, RestoresTheWholeState, ()) {
  const WorldState state = random::state();
  RC_ASSERT(isValid(state));
  RC_ASSERT(restore(snapshot(state)) == state);
}

RC_GTEST_PROP(Snapshot, OfAnotherLengthIsRefused, ()) {
  auto bytes = snapshot(random::state());
  const auto kept = *rc::gen::inRange<std::size_t>(0, bytes.size());
  const std::vector<std::byte> cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(kept));
  RC_ASSERT(refusal(cut).find("cut short") != std::string::npos);
  bytes.push_back(std::byte{0});
  RC_ASSERT(refusal(bytes).find("after its end") != std::string::npos);
}

RC_GTEST_PROP(Snapshot, OfAnyBytesIsRestoredOrRefused, ()) {
  auto bytes = snapshot(random::state());
  const auto changes = *rc::gen::inRange(1, 5);
  for (int i = 0; i < changes; ++i)
    bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] =
        static_cast<std::byte>(*rc::gen::inRange(0, 256));
  try {
    RC_ASSERT(isValid(restore(bytes)));
  } catch (const std::runtime_error& e) {
    RC_ASSERT(std::string(e.what()).starts_with("world snapshot: "));
  }
}

TEST(Snapshot, NamesItsLayoutAndRefusesAnother) {
  auto bytes = snapshot({});
  bytes[4] = std::byte{kSnapshotLayout + 1};
  const std::string why = refusal(bytes);
  EXPECT_NE(why.find("layout version " + std::to_string(kSnapshotLayout + 1)), std::string::npos) << why;
  EXPECT_NE(why.find("reads " + std::to_string(kSnapshotLayout)), std::string::npos) << why;
}

TEST(Snapshot, OfSomethingElseIsRefused) {
  EXPECT_NE(refusal({std::byte{'P'}, std::byte{'N'}, std::byte{'G'}}).find("COHS"), std::string::npos);
  EXPECT_NE(refusal({}).find("cut short"), std::string::npos);
}

TEST(Snapshot, OfWhatCannotBeIsRefused) {
  WorldState beyond;
  beyond.master.base.x_nm = kWorldLimitNm + 1;
  EXPECT_NE(refusal(snapshot(beyond)), "");
  WorldState door;
  door.doors.push_back(-1);
  EXPECT_NE(refusal(snapshot(door)), "");
  WorldState askew;
  askew.movables.emplace_back().attitude = {0, 0, 0, 0};
  EXPECT_NE(refusal(snapshot(askew)), "");
  WorldState mode;
  mode.mode = static_cast<Mode>(2);
  EXPECT_NE(refusal(snapshot(mode)), "");
}

TEST(Snapshot, CountsBeyondTheStatesAreRefusedBeforeAnythingIsMade) {
  WorldState state;
  auto bytes = snapshot(state);
  // Tick 8, mode 1, two vehicles of 40, closed hands 1, then the number of movables.
  bytes[6 + 8 + 1 + 2 * 40 + 1] = std::byte{200};
  EXPECT_NE(refusal(bytes).find("number of movables is 200"), std::string::npos) << refusal(bytes);
}

}  // namespace
}  // namespace coherency
