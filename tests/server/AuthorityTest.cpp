#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/FixedPoint.h"
#include "common/motion/CompactCode.h"
#include "motion_server/authority/Authority.h"

namespace coherency {
namespace {

/// Pushes the stick ahead until told to end.
class Pusher final : public Master {
 public:
  std::string name() const override { return "pusher"; }
  std::optional<MasterReading> read(std::int64_t elapsed_ns, const WorldState& world) override {
    seen = world;
    if (ended) return std::nullopt;
    MasterReading reading;
    reading.device_time_us = elapsed_ns / 1000;
    reading.si[index(Dof::HeadY)] = head_y;
    // It moves as people do, however the mode is.
    reading.si[index(Dof::HeadYaw)] = 0.3 * std::sin(static_cast<double>(elapsed_ns) * 2e-9);
    reading.si[index(Dof::ElbowFlexion)] = 1.0 + 0.2 * std::cos(static_cast<double>(elapsed_ns) * 3e-9);
    reading.si[index(Dof::StickY)] = stick;
    return reading;
  }
  WorldState seen;
  bool ended = false;
  double head_y = 1.2;
  double stick = 1.0;
};

WorldModel model() {
  WorldModel m;
  m.master.start.x_nm = 5;
  m.robot.emplace();
  return m;
}

/// An authority over a plane with a robot on it.
struct Ruled {
  explicit Ruled(Master& master, DofMask dofs = kAllDofs, bool compact = false)
      : world(model()), authority(config(dofs, compact), world, master) {}
  AuthorityConfig config(DofMask dofs, bool compact) const {
    AuthorityConfig c;
    c.start = world.initialState();
    c.dofs = dofs;
    c.compact = compact;
    return c;
  }
  World world;
  Authority authority;
};

TEST(Authority, NumbersSamplesAndStepsTheWorldFromItsStart) {
  Pusher master;
  Ruled ruled(master);
  Authority& authority = ruled.authority;
  const auto first = authority.sample(1'000'000, 42, 1);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->sample.sequence, 1u);
  EXPECT_EQ(first->sample.server_time_ns, 42);
  EXPECT_EQ(first->sample.device_time_us, 1000);
  EXPECT_EQ(first->world.tick, 1u);
  EXPECT_EQ(first->world.master.base.x_nm, 5);
  EXPECT_EQ(master.seen.tick, 0u) << "the master saw the world before the step";
  EXPECT_EQ(authority.sample(2'000'000, 43, 1)->sample.sequence, 2u);
  EXPECT_EQ(master.seen, first->world);
}

RC_GTEST_PROP(Authority, TickIsElapsedPeriodsWhateverWasMissed, ()) {
  Pusher missing_master, steady_master;
  Ruled missing_ruled(missing_master), steady_ruled(steady_master);
  Authority& missing = missing_ruled.authority;
  Authority& steady = steady_ruled.authority;
  std::uint64_t tick = 0;
  for (int i = 0; i < 20; ++i) {
    const auto elapsed = *rc::gen::inRange<std::uint64_t>(1, 9);
    tick += elapsed;
    const auto result = missing.sample(static_cast<std::int64_t>(tick) * 1'000'000, 0, elapsed);
    RC_ASSERT(result->world.tick == tick);
    RC_ASSERT(result->sample.sequence == static_cast<std::uint64_t>(i + 1));
  }
  for (std::uint64_t k = 1; k <= tick; ++k) steady.sample(static_cast<std::int64_t>(k) * 1'000'000, 0, 1);
  RC_ASSERT(missing.state() == steady.state());
}

TEST(Authority, SaysWhenTheMasterHasEndedAndChangesNothing) {
  Pusher master;
  Ruled ruled(master);
  Authority& authority = ruled.authority;
  authority.sample(1'000'000, 0, 1);
  const WorldState before = authority.state();
  master.ended = true;
  EXPECT_FALSE(authority.sample(2'000'000, 0, 1));
  EXPECT_EQ(authority.state(), before);
}

TEST(Authority, DofsThatASceneDoesNotNeedAreNeverValid) {
  Pusher master;
  Ruled ruled(master, mask(Dof::HeadY));
  const auto result = ruled.authority.sample(1'000'000, 0, 1);
  EXPECT_EQ(result->sample.valid, mask(Dof::HeadY));
  EXPECT_EQ(result->sample.units[index(Dof::StickY)], 0);
  EXPECT_EQ(result->world.master.velocity_ahead_um, 0) << "and drive nothing";
}

TEST(Authority, SwitchesModesBetweenTwoSamples) {
  Pusher switching_master, steady_master;
  Ruled switching(switching_master), steady(steady_master);
  for (int k = 1; k <= 200; ++k) {
    if (k == 100) {
      EXPECT_TRUE(switching.authority.switchTo(Mode::Robot));
    }
    const auto result = switching.authority.sample(k * 1'000'000, 0, 1);
    const auto without = steady.authority.sample(k * 1'000'000, 0, 1);
    EXPECT_EQ(result->world.mode, k < 100 ? Mode::Operator : Mode::Robot) << k;
    EXPECT_EQ(result->sample.units, without->sample.units) << "the posture is what it would have been";
  }
  EXPECT_GT(switching.authority.state().robot.velocity_ahead_um, 0);
  EXPECT_EQ(steady.authority.state().robot.velocity_ahead_um, 0);
}

TEST(Authority, PassesOverAModeThereIsNot) {
  Pusher master;
  const World world{WorldModel{}};
  Authority authority({world.initialState()}, world, master);
  EXPECT_FALSE(authority.switchTo(Mode::Robot));
  EXPECT_EQ(authority.sample(1'000'000, 0, 1)->world.mode, Mode::Operator);
}

TEST(Authority, BadReadingsAreRefusedAndCounted) {
  Pusher master;
  Ruled ruled(master);
  Authority& authority = ruled.authority;
  authority.sample(1'000'000, 0, 1);
  master.head_y = std::numeric_limits<double>::quiet_NaN();
  const auto result = authority.sample(2'000'000, 0, 1);
  EXPECT_FALSE(result->sample.isValid(Dof::HeadY));
  EXPECT_NEAR(result->sample.si(Dof::HeadY), 1.2, 1e-6);
  EXPECT_EQ(authority.refused()[index(Dof::HeadY)], 1u);
}

TEST(Authority, CompactSamplesAreAtCodesAndTheWorldIsSteppedWithThem) {
  Pusher compact_master, exact_master;
  compact_master.stick = exact_master.stick = 0.33333;
  Ruled compact(compact_master, kAllDofs, true), exact(exact_master);
  WorldState stepped = compact.world.initialState();
  for (int k = 1; k <= 200; ++k) {
    const auto coarse = compact.authority.sample(k * 1'000'000, 0, 1);
    const auto fine = exact.authority.sample(k * 1'000'000, 0, 1);
    EXPECT_EQ(coarse->sample, compacted(fine->sample));
    EXPECT_NE(coarse->sample, fine->sample);
    compact.world.step(stepped, coarse->sample, 1'000'000);
    EXPECT_EQ(coarse->world, stepped);
  }
  EXPECT_NE(compact.authority.state().master, exact.authority.state().master);
}

TEST(Authority, WhatDoesNotTravelStandsStillWhereItIsSaidTo) {
  for (const bool compact : {false, true}) {
    Pusher master;
    const DofMask dofs = mask(Dof::HeadY) | mask(Dof::StickY);
    Ruled ruled(master, dofs, compact);
    const auto still = ruled.authority.still();
    for (int k = 1; k <= 20; ++k) {
      const MotionSample sample = ruled.authority.sample(k * 1'000'000, 0, 1)->sample;
      for (std::size_t i = 0; i < kDofCount; ++i)
        if ((dofs & mask(dofAt(i))) == 0) {
          EXPECT_EQ(sample.units[i], still[i]) << i;
        }
      EXPECT_NE(sample.units[index(Dof::StickY)], still[index(Dof::StickY)]);
    }
    MotionSample standing;
    standing.units = still;
    EXPECT_EQ(compact ? compacted(standing) : standing, standing);
  }
}

}  // namespace
}  // namespace coherency
