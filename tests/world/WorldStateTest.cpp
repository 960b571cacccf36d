#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/FixedPoint.h"
#include "common/world/StateFields.h"
#include "tests/world/Generators.h"

namespace coherency {
namespace {

TEST(StateHash, KnownValue) {
  // FNV-1a over zero bytes: tick 8, mode 1, vehicles 2 x 40, hands 1, counts 2, task 21; the sample's 24 + 4
  // + 76.
  std::uint64_t expected = 0xCBF29CE484222325U;
  for (int i = 0; i < 8 + 1 + 80 + 1 + 2 + 21 + 104; ++i) expected *= 0x100000001B3U;
  EXPECT_EQ(stateHash({}, {}), expected);
}

/// Changes one bit of field number `which`; true if there is such a field.
bool flip(WorldState& state, int which) {
  int number = 0;
  bool done = false;
  forEachField(state, [&](const char*, auto& field) {
    if (number++ != which) return;
    done = true;
    using Field = std::remove_reference_t<decltype(field)>;
    if constexpr (std::is_same_v<Field, bool>)
      field = !field;
    else
      field = static_cast<Field>(static_cast<std::int64_t>(field) ^ 1);
  });
  return done;
}

RC_GTEST_PROP(StateHash, ChangesWithEveryField, ()) {
  WorldState s = random::state();
  s.movables.resize(kMaxMovables - 1);  // so that one more fits
  s.doors.resize(kMaxDoors - 1);
  MotionSample m;
  for (std::int32_t& units : m.units) units = *rc::gen::arbitrary<std::int32_t>();
  std::set<std::uint64_t> seen = {stateHash(s, m)};
  for (int which = 0;; ++which) {
    WorldState other = s;
    if (!flip(other, which)) break;
    RC_ASSERT(seen.insert(stateHash(other, m)).second);
  }
  RC_ASSERT(seen.size() > 15 + (kMaxMovables - 1) * 10);
  const auto bit = *rc::gen::inRange(0, 19);
  const std::vector<std::function<void(MotionSample&)>> changes = {
      [&](auto& x) { x.sequence ^= std::uint64_t{1} << bit; },
      [&](auto& x) { x.server_time_ns ^= std::int64_t{1} << bit; },
      [&](auto& x) { x.device_time_us ^= std::int64_t{1} << bit; },
      [&](auto& x) { x.valid ^= DofMask{1} << bit; },
  };
  for (const auto& change : changes) {
    MotionSample sample = m;
    change(sample);
    RC_ASSERT(seen.insert(stateHash(s, sample)).second);
  }
  for (std::size_t i = 0; i < kDofCount; ++i) {
    MotionSample sample = m;
    sample.units[i] ^= 1 << bit;
    RC_ASSERT(seen.insert(stateHash(s, sample)).second);
  }
}

RC_GTEST_PROP(Movable, KeepsItsAttitudeWithinABillionth, ()) {
  const TransformMatrix turn = random::rotationMatrix();
  Movable m;
  setAttitude(m, quaternion(turn));
  RC_ASSERT(m.attitude[3] >= 0);
  RC_ASSERT(largestDifference(rotation(attitude(m)), turn) < 4e-9);
}

TEST(BasePose, RefusesWhatIsBeyondTheWorld) {
  EXPECT_THROW(basePose(1.1e9, 0.0, 0.0), std::range_error);
  EXPECT_THROW(basePose(0.0, -1e300, 0.0), std::range_error);
  EXPECT_THROW(basePose(0.0, std::nan(""), 0.0), std::range_error);
  EXPECT_THROW(basePose(0.0, 0.0, std::numeric_limits<double>::infinity()), std::range_error);
  EXPECT_EQ(basePose(1e9, -1e9, 0.0).x_nm, kWorldLimitNm);
}

TEST(BasePose, MovesToTheNearestNanometreAndNoFartherThanTheWorldGoes) {
  EXPECT_EQ(movedBy(5, 1.4e-9), 6);
  EXPECT_EQ(movedBy(kWorldLimitNm - 3, 1.0), kWorldLimitNm);
  EXPECT_EQ(movedBy(-kWorldLimitNm + 3, -1.0), -kWorldLimitNm);
}

}  // namespace
}  // namespace coherency
