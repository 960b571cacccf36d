#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/world/Snapshot.h"
#include "common/world/StateFields.h"
#include "tests/world/Generators.h"

namespace coherency {
namespace {

/// The model of a world that such states are of.
WorldModel modelOf(const WorldState& state) {
  WorldModel model;
  model.robot.emplace();
  model.movables.resize(state.movables.size());
  model.doors.resize(state.doors.size());
  return model;
}

std::string refusal(const std::vector<std::byte>& bytes, const World& world = World(WorldModel{})) {
  try {
    restore(bytes, world);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

RC_GTEST_PROP(Snapshot, RestoresTheWholeState, ()) {
  const WorldState state = random::state();
  RC_ASSERT(isValid(state));
  RC_ASSERT(restore(snapshot(state), World(modelOf(state))) == state);
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
  const WorldState state = random::state();
  const World world(modelOf(state));
  auto bytes = snapshot(state);
  const auto changes = *rc::gen::inRange(1, 5);
  for (int i = 0; i < changes; ++i)
    bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] =
        static_cast<std::byte>(*rc::gen::inRange(0, 256));
  try {
    WorldState restored = restore(bytes, world);
    RC_ASSERT(world.fits(restored));
    world.step(restored, neutralSample(Rig{}), 1'000'000);
    RC_ASSERT(isValid(restored));
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
  WorldState fast;
  fast.robot.velocity_ahead_um = std::numeric_limits<std::int32_t>::max();
  EXPECT_NE(refusal(snapshot(fast)), "");
  WorldState turning;
  turning.master.turn_rate_units = std::numeric_limits<std::int32_t>::min();
  EXPECT_NE(refusal(snapshot(turning)), "");
  WorldState falling;
  falling.movables.emplace_back().fall_um = -1;
  EXPECT_NE(refusal(snapshot(falling)), "");
  WorldState unresting;
  unresting.movables.emplace_back().unrest_us = 4'294'967'295U;
  EXPECT_NE(refusal(snapshot(unresting)), "");
  WorldState mode;
  mode.mode = static_cast<Mode>(2);
  EXPECT_NE(refusal(snapshot(mode)), "");
}

TEST(Snapshot, OfAnotherWorldIsRefused) {
  WorldModel model;
  model.movables.resize(3);
  model.doors.resize(1);
  const World world(model);
  const WorldState start = world.initialState();
  EXPECT_EQ(refusal(snapshot(start), world), "");
  WorldState other = start;
  other.movables.emplace_back();
  EXPECT_NE(refusal(snapshot(other), world).find("4 things to grasp"), std::string::npos);
  EXPECT_THROW(world.step(other, neutralSample(Rig{}), 1'000'000), std::invalid_argument);
  other = start;
  other.doors.push_back(0);
  EXPECT_NE(refusal(snapshot(other), world).find("2 doors"), std::string::npos);
  EXPECT_THROW(world.step(other, neutralSample(Rig{}), 1'000'000), std::invalid_argument);
  other = start;
  other.mode = Mode::Robot;
  EXPECT_NE(refusal(snapshot(other), world).find("without a robot"), std::string::npos);
  other = start;
  other.movables[0].holder = Holder::RobotHand;
  EXPECT_NE(refusal(snapshot(other), world), "");
  other = start;
  other.closed_hands = 2;
  EXPECT_NE(refusal(snapshot(other), world), "");
  other = start;
  other.master.velocity_ahead_um = 2'000'000;
  EXPECT_NE(refusal(snapshot(other), world), "") << "nothing here drives so fast";
}

/// Whoever changes a field, its size or its place takes another kSnapshotLayout, and notes the bytes here.
TEST(Snapshot, HasTheBytesOfItsLayout) {
  WorldState state;
  state.movables.resize(2);
  state.doors.resize(1);
  std::uint8_t next = 0;
  forEachField(state, [&](const char* name, auto& field) {
    using Field = std::remove_reference_t<decltype(field)>;
    if (!std::string(name).starts_with("number of")) field = static_cast<Field>(++next);
  });
  const auto bytes = snapshot(state);
  std::uint64_t hash = 0xCBF29CE484222325U;  // FNV-1a
  for (const std::byte b : bytes) hash = (hash ^ std::to_integer<std::uint64_t>(b)) * 0x100000001B3U;
  EXPECT_EQ(kSnapshotLayout, 1);
  EXPECT_EQ(bytes.size(), 223U);
  EXPECT_EQ(hash, 1556827274295443586U);
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
