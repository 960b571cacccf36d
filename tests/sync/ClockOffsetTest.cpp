#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/sync/ClockOffset.h"

namespace coherency {
namespace {

/// Two clocks and the network between them, in true time, which is the client's clock.
struct Simulation {
  std::int64_t start_offset_ns = 0;
  double drift_ppm = 0;

  std::int64_t offsetAt(std::int64_t true_ns) const {
    return start_offset_ns + std::llround(static_cast<double>(true_ns) * drift_ppm * 1e-6);
  }
  ClockExchange exchange(std::int64_t at, std::int64_t there, std::int64_t serving, std::int64_t back) const {
    const std::int64_t arrives = at + there;
    const std::int64_t leaves = arrives + serving;
    return {{at}, {arrives + offsetAt(arrives)}, {leaves + offsetAt(leaves)}, {leaves + back}};
  }
};

TEST(ClockOffset, KnowsNothingAtFirst) {
  EXPECT_FALSE(ClockOffset().known());
}

TEST(ClockOffset, IsExactOnASymmetricPath) {
  const Simulation network{.start_offset_ns = -123'456'789};
  ClockOffset offset;
  ASSERT_TRUE(offset.add(network.exchange(1'000, 50'000, 7'000, 50'000)));
  EXPECT_EQ(offset.offsetNs(), -123'456'789);
  EXPECT_EQ(offset.toServer({5}).ns, 5 - 123'456'789);
  EXPECT_EQ(offset.toClient({5}).ns, 5 + 123'456'789);
}

TEST(ClockOffset, RefusesTimesThatContradictEachOther) {
  ClockOffset offset;
  EXPECT_FALSE(offset.add({{10}, {0}, {0}, {9}}));    // answered before it was asked
  EXPECT_FALSE(offset.add({{0}, {10}, {9}, {100}}));  // answered before it was received
  EXPECT_FALSE(offset.add({{0}, {0}, {50}, {49}}));   // served for longer than it was under way
  EXPECT_FALSE(offset.known());
}

TEST(ClockOffset, KeepsTheShortestRoundTrip) {
  const Simulation network{.start_offset_ns = 1'000'000};
  ClockOffset offset;
  offset.add(network.exchange(0, 20'000, 0, 20'000));
  offset.add(network.exchange(1'000'000, 900'000, 0, 20'000));  // queued on its way
  EXPECT_EQ(offset.offsetNs(), 1'000'000);
}

TEST(ClockOffset, AgeLetsGoOfAnOldExchange) {
  const Simulation network{.drift_ppm = 50};
  ClockOffset offset;
  offset.add(network.exchange(0, 10'000, 0, 10'000));
  const std::int64_t later = 100'000'000'000;
  offset.add(network.exchange(later, 30'000, 0, 30'000));
  EXPECT_NEAR(static_cast<double>(offset.offsetNs()), 5'000'000, 10);
  EXPECT_LT(offset.boundNs({later + 60'000}), 31'000);
}

TEST(ClockOffset, BoundGrowsWithAge) {
  ClockOffset offset(100.0);
  offset.add(Simulation{}.exchange(0, 10'000, 0, 10'000));
  EXPECT_GE(offset.boundNs({1'000'000'000}), 10'000 + 100'000);
  EXPECT_LE(offset.boundNs({1'000'000'000}), 10'000 + 100'000 + 10);
}

TEST(ClockOffset, ASetClockIsBelievedAtOnce) {
  ClockOffset offset;
  offset.add(Simulation{.start_offset_ns = 0}.exchange(0, 10'000, 0, 10'000));
  offset.add(Simulation{.start_offset_ns = 5'000'000'000}.exchange(1'000'000, 90'000, 0, 20'000));
  EXPECT_NEAR(static_cast<double>(offset.offsetNs()), 5e9, 55'000);
}

// Delay, jitter, asymmetry, service time and drift are arbitrary; the truth must never leave the bound, at
// any time.
RC_GTEST_PROP(ClockOffset, TruthIsAlwaysWithinTheBound, ()) {
  const Simulation network{
      .start_offset_ns = *rc::gen::inRange<std::int64_t>(-1'000'000'000'000, 1'000'000'000'000),
      .drift_ppm = *rc::gen::inRange(-1000, 1001) * 0.1};
  ClockOffset offset(100.0);
  std::int64_t t = 0;
  const int exchanges = *rc::gen::inRange(1, 60);
  for (int i = 0; i < exchanges; ++i) {
    t += *rc::gen::inRange<std::int64_t>(0, 2'000'000'000);
    const auto there = *rc::gen::inRange<std::int64_t>(0, 50'000'000);
    const auto serving = *rc::gen::inRange<std::int64_t>(0, 1'000'000);
    // 1 us: drift cannot make the round trip negative.
    const auto back = *rc::gen::inRange<std::int64_t>(1'000, 50'000'000);
    RC_ASSERT(offset.add(network.exchange(t, there, serving, back)));
    t += there + serving + back;
    for (const std::int64_t later : {std::int64_t{0}, std::int64_t{1'000'000}, std::int64_t{3'000'000'000}}) {
      const std::int64_t error = std::abs(offset.offsetNs() - network.offsetAt(t + later));
      RC_ASSERT(error <= offset.boundNs({t + later}));
    }
  }
}

}  // namespace
}  // namespace coherency
