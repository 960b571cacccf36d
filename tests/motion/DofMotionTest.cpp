#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/motion/DofMotion.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

Dof anyDof() {
  return dofAt(*rc::gen::inRange<std::size_t>(0, kDofCount));
}

std::int32_t anyUnits() {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::int32_t>());
}

TEST(DofMotion, StickAndPedalsAreCommands) {
  EXPECT_TRUE(movesOn(Dof::HeadX));
  EXPECT_TRUE(movesOn(Dof::WristDeviation));
  EXPECT_TRUE(movesOn(Dof::Grip));
  EXPECT_FALSE(movesOn(Dof::StickX));
  EXPECT_FALSE(movesOn(Dof::PedalRight));
}

TEST(DofMotion, AnglesGoTheShorterWayRound) {
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
  EXPECT_EQ(displacement(Dof::HeadYaw, kMost, kLeast), 1.0);
  EXPECT_EQ(displacement(Dof::HeadX, kMost, kLeast), -4294967295.0);
  EXPECT_EQ(moved(Dof::HeadYaw, kMost, 1.0), kLeast);
}

/// The shoulder's flexion has 3.2 rad, beyond the seam at 180 degrees.
TEST(DofMotion, ARangeOverTheSeamIsWhole) {
  const auto units = [](double rad) { return unitsFromSi(DofKind::Angle, rad); };
  const double step = displacement(Dof::ShoulderFlexion, units(3.1), units(3.18));
  EXPECT_NEAR(moved(Dof::ShoulderFlexion, units(3.1), step), units(3.18), 2);
  EXPECT_NEAR(moved(Dof::ShoulderFlexion, units(3.18), step), units(3.2), 2);
}

RC_GTEST_PROP(DofMotion, StaysInRangeWhateverComes, ()) {
  const Dof dof = anyDof();
  const DofInfo& range = info(dof);
  const std::int32_t after = moved(dof, anyUnits(), random::magnitude(-3, 300));
  if (dof == Dof::HeadYaw || dof == Dof::HeadRoll) return;
  double si = siFromUnits(range.kind, after);
  if (range.kind == DofKind::Angle && si < range.min - 1e-6) si += 2.0 * 3.14159265358979323846;
  RC_ASSERT(si >= range.min - 2.0 * resolution(range.kind));
  RC_ASSERT(si <= range.max + 2.0 * resolution(range.kind));
}

RC_GTEST_PROP(DofMotion, InRangeItGoesAsFarAsItIsTold, ()) {
  const Dof dof = anyDof();
  const DofInfo& range = info(dof);
  const double from = random::real(range.min, range.max), to = random::real(range.min, range.max);
  const std::int32_t a = unitsFromSi(range.kind, from), b = unitsFromSi(range.kind, to);
  const double by = (to - from) / resolution(range.kind);
  RC_PRE(std::abs(by) < 2147483648.0);
  RC_ASSERT(std::abs(displacement(dof, b, moved(dof, a, by))) <= 2.0);
}

RC_GTEST_PROP(DofMotion, IntervalsAreOfMotionThatGoesOn, ()) {
  MotionSample a, b;
  a.sequence = *rc::gen::arbitrary<std::uint64_t>();
  b.sequence = *rc::gen::arbitrary<std::uint64_t>();
  a.server_time_ns = *rc::gen::arbitrary<std::int64_t>();
  const auto later = *rc::gen::inRange<std::int64_t>(-5, 200'000'000);
  b.server_time_ns = static_cast<std::int64_t>(static_cast<std::uint64_t>(a.server_time_ns) +
                                               static_cast<std::uint64_t>(later));
  const bool goes_on = a.sequence != 0 && b.sequence > a.sequence && b.server_time_ns > a.server_time_ns &&
                       later <= kMotionGapNs;
  RC_ASSERT(intervalSeconds(a, b) == (goes_on ? static_cast<double>(later) * 1e-9 : 0.0));
}

}  // namespace
}  // namespace coherency
