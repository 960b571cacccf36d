#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/relay/Impairment.h"

namespace coherency {
namespace {

using Drop = DatagramFate::Drop;

constexpr std::int64_t kMs = 1'000'000;
constexpr std::size_t kBytes = 500;

/// One datagram every `every_ns`.
std::vector<DatagramFate> fates(const ImpairmentSettings& settings, const ImpairmentStream& stream, int count,
                                std::int64_t every_ns = kMs, std::size_t bytes = kBytes) {
  Impairment impairment(stream, settings, 0);
  std::vector<DatagramFate> all;
  for (int i = 0; i < count; ++i) all.push_back(impairment.pass(i * every_ns, bytes));
  return all;
}

template <class Predicate>
int countIf(const std::vector<DatagramFate>& all, Predicate predicate) {
  return static_cast<int>(std::count_if(all.begin(), all.end(), predicate));
}

/// Within five standard deviations of the binomial distribution: one seed in two million is outside.
void expectBinomial(int count, int of, double p) {
  EXPECT_NEAR(count, of * p, 5.0 * std::sqrt(of * p * (1.0 - p)));
}

struct Interval {
  std::int64_t begin_ns, length_ns;
};

/// Runs of what bursts took, as seen by datagrams at so short an interval.
std::vector<Interval> bursts(const std::vector<DatagramFate>& all, std::int64_t every_ns) {
  std::vector<Interval> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].drop != Drop::Burst) continue;
    if (i == 0 || all[i - 1].drop != Drop::Burst)
      found.push_back({static_cast<std::int64_t>(i) * every_ns, 0});
    found.back().length_ns += every_ns;
  }
  return found;
}

ImpairmentSettings arbitrarySettings() {
  const auto probability = [] { return *rc::gen::inRange(0, 101) / 100.0; };
  ImpairmentSettings s;
  s.loss = probability() / 2.0;
  s.burst_every_ns = *rc::gen::element<std::int64_t>(0, 10 * kMs, 300 * kMs);
  s.burst_ns = s.burst_every_ns / *rc::gen::inRange<std::int64_t>(1, 20);
  s.bursts_regular = *rc::gen::arbitrary<bool>();
  s.delay_ns = *rc::gen::inRange<std::int64_t>(0, 20 * kMs);
  s.jitter_ns = *rc::gen::inRange<std::int64_t>(0, 20 * kMs);
  s.reorder = *rc::gen::arbitrary<bool>();
  s.duplicate = probability();
  s.corrupt = probability();
  return s;
}

RC_GTEST_PROP(Impairment, NoSettingsAreTheIdentity, (std::uint64_t seed, std::uint32_t flow)) {
  Impairment impairment({seed, flow, 1}, {}, 0);
  std::int64_t now = 0;
  for (int i = 0; i < 100; ++i) {
    now += *rc::gen::inRange<std::int64_t>(0, 100 * kMs);
    const DatagramFate fate = impairment.pass(now, kBytes);
    RC_ASSERT(fate.drop == Drop::None && fate.copies == 1 && fate.leaves_ns[0] == now && !fate.flipped_bit);
  }
}

RC_GTEST_PROP(Impairment, TheSameSeedHasTheSameFate, (std::uint64_t seed, std::uint32_t flow)) {
  const ImpairmentSettings settings = arbitrarySettings();
  RC_ASSERT(fates(settings, {seed, flow, 0}, 200) == fates(settings, {seed, flow, 0}, 200));
}

RC_GTEST_PROP(Impairment, WithoutReorderNoneOvertakesAnother, (std::uint64_t seed)) {
  ImpairmentSettings settings = arbitrarySettings();
  settings.reorder = false;
  Impairment impairment({seed, 0, 0}, settings, 0);
  std::int64_t now = 0, last = 0;
  for (int i = 0; i < 200; ++i) {
    now += *rc::gen::inRange<std::int64_t>(0, 3 * kMs);
    const DatagramFate fate = impairment.pass(now, kBytes);
    for (int copy = 0; copy < fate.copies; ++copy) {
      const std::int64_t leaves = fate.leaves_ns[static_cast<std::size_t>(copy)];
      RC_ASSERT(leaves >= last);
      RC_ASSERT(leaves >= now + settings.delay_ns);
      RC_ASSERT(leaves == last || leaves <= now + settings.delay_ns + settings.jitter_ns);
      last = leaves;
    }
  }
}

RC_GTEST_PROP(Impairment, WithReorderEachHasItsOwnJitter, (std::uint64_t seed)) {
  ImpairmentSettings settings = arbitrarySettings();
  settings.reorder = true;
  const auto all = fates(settings, {seed, 0, 0}, 200);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::int64_t soonest = static_cast<std::int64_t>(i) * kMs + settings.delay_ns;
    for (int copy = 0; copy < all[i].copies; ++copy) {
      const std::int64_t leaves = all[i].leaves_ns[static_cast<std::size_t>(copy)];
      RC_ASSERT(leaves >= soonest && leaves <= soonest + settings.jitter_ns);
    }
    if (all[i].copies == 2) RC_ASSERT(all[i].leaves_ns[0] <= all[i].leaves_ns[1]);
  }
}

RC_GTEST_PROP(Impairment, WhatIsLostAtALowerRateIsLostAtAHigherOne, (std::uint64_t seed)) {
  ImpairmentSettings low = arbitrarySettings();
  ImpairmentSettings high = low;
  high.loss = low.loss + 0.3;
  high.delay_ns = 7 * kMs;
  const auto fewer = fates(low, {seed, 0, 0}, 200);
  const auto more = fates(high, {seed, 0, 0}, 200);
  for (std::size_t i = 0; i < fewer.size(); ++i)
    if (fewer[i].drop != Drop::None) RC_ASSERT(more[i].drop == fewer[i].drop);
}

RC_GTEST_PROP(Impairment, BurstsAreIntervalsOfTimeAtAnyRate, (std::uint64_t seed, bool regular)) {
  ImpairmentSettings settings;
  settings.burst_every_ns = 50 * kMs;
  settings.burst_ns = 7 * kMs;
  settings.bursts_regular = regular;
  const auto often = fates(settings, {seed, 0, 0}, 10'000, kMs / 10);
  const auto seldom = fates(settings, {seed, 0, 0}, 100, 10 * kMs);
  for (std::size_t i = 0; i < seldom.size(); ++i) RC_ASSERT(seldom[i].drop == often[100 * i].drop);
}

TEST(Impairment, RatesAreThoseAskedFor) {
  constexpr int kCount = 100'000;
  ImpairmentSettings settings;
  settings.loss = 0.05;
  settings.duplicate = 0.01;
  settings.corrupt = 0.002;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto all = fates(settings, {seed, 0, 0}, kCount);
    const int passed = countIf(all, [](const auto& f) { return f.drop == Drop::None; });
    EXPECT_EQ(countIf(all, [](const auto& f) { return f.drop == Drop::Loss; }), kCount - passed);
    expectBinomial(kCount - passed, kCount, settings.loss);
    expectBinomial(countIf(all, [](const auto& f) { return f.copies == 2; }), passed, settings.duplicate);
    expectBinomial(countIf(all, [](const auto& f) { return f.flipped_bit.has_value(); }), passed,
                   settings.corrupt);
  }
}

TEST(Impairment, LossesOfOneStreamSayNothingOfTheNextDatagramNorOfAnotherStream) {
  constexpr int kCount = 100'000;
  ImpairmentSettings settings;
  settings.loss = 0.2;
  const auto lost = [](const DatagramFate& f) { return f.drop == Drop::Loss; };
  const auto one = fates(settings, {3, 0, 0}, kCount);
  for (const ImpairmentStream other :
       {ImpairmentStream{3, 0, 1}, ImpairmentStream{3, 1, 0}, ImpairmentStream{4, 0, 0},
        ImpairmentStream{3 + (std::uint64_t{1} << 32), 0, 0}}) {
    const auto two = fates(settings, other, kCount);
    int both = 0;
    for (std::size_t i = 0; i < one.size(); ++i) both += lost(one[i]) && lost(two[i]);
    expectBinomial(both, kCount, 0.04);
  }
  int after_another = 0;
  for (std::size_t i = 1; i < one.size(); ++i) after_another += lost(one[i - 1]) && lost(one[i]);
  // Neighbouring pairs overlap, which widens the binomial's variance to p^2 (1 + 2 p - 3 p^2).
  EXPECT_NEAR(after_another, kCount * 0.04, 5.0 * std::sqrt(kCount * 0.04 * (1.0 + 0.4 - 0.12)));
}

TEST(Impairment, JitterIsUniform) {
  constexpr int kCount = 100'000;
  ImpairmentSettings settings;
  settings.jitter_ns = 8 * kMs;
  settings.reorder = true;
  std::array<int, 8> counts{};
  int overtaken = 0;
  const auto all = fates(settings, {11, 0, 0}, kCount);
  for (std::size_t i = 0; i < all.size(); ++i) {
    ++counts.at(static_cast<std::size_t>((all[i].leaves_ns[0] - static_cast<std::int64_t>(i) * kMs) / kMs));
    overtaken += i > 0 && all[i].leaves_ns[0] < all[i - 1].leaves_ns[0];
  }
  for (const int count : counts) expectBinomial(count, kCount, 1.0 / 8.0);
  EXPECT_NEAR(overtaken / double{kCount}, 0.5 * (7.0 / 8.0) * (7.0 / 8.0),
              0.01);  // area of the triangle y < x - 1/8
}

TEST(Impairment, RegularBurstsHaveOneLengthAndOnePeriod) {
  ImpairmentSettings settings;
  settings.burst_every_ns = 1000 * kMs;
  settings.burst_ns = 20 * kMs;
  settings.bursts_regular = true;
  const auto found = bursts(fates(settings, {5, 0, 0}, 200'000, kMs / 10), kMs / 10);  // 20 s
  ASSERT_GE(found.size(), 19U);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].length_ns, settings.burst_ns);
    EXPECT_EQ(found[i].begin_ns, found[0].begin_ns + static_cast<std::int64_t>(i) * settings.burst_every_ns);
  }
  const auto elsewhere = bursts(fates(settings, {6, 0, 0}, 20'000, kMs / 10), kMs / 10);
  EXPECT_NE(elsewhere.at(0).begin_ns, found[0].begin_ns);
}

TEST(Impairment, BurstsAtRandomHaveOneLengthAndExponentialGaps) {
  ImpairmentSettings settings;
  settings.burst_every_ns = 100 * kMs;
  settings.burst_ns = 20 * kMs;
  constexpr int kCount = 2'000'000;
  const auto found = bursts(fates(settings, {5, 0, 0}, kCount, kMs / 10), kMs / 10);  // 200 s
  const int expected = 2000;
  // A renewal process of so many gaps: the deviation of its count is sqrt(n) * (80 ms / 100 ms).
  EXPECT_NEAR(static_cast<int>(found.size()), expected, 5.0 * std::sqrt(expected) * 0.8);
  int gaps_above_mean = 0;
  for (std::size_t i = 1; i + 1 < found.size(); ++i) {
    // Two bursts with nothing seen between them are one run.
    const std::int64_t odd = found[i].length_ns % settings.burst_ns;
    EXPECT_LE(std::min(odd, settings.burst_ns - odd),
              kMs / 10 * (1 + found[i].length_ns / settings.burst_ns));
    gaps_above_mean += found[i].begin_ns - found[i - 1].begin_ns - found[i - 1].length_ns > 80 * kMs;
  }
  expectBinomial(gaps_above_mean, static_cast<int>(found.size()) - 2, std::exp(-1.0));
}

TEST(Impairment, Extremes) {
  ImpairmentSettings settings;
  settings.loss = 1.0;
  EXPECT_EQ(countIf(fates(settings, {1, 0, 0}, 1000),
                    [](const auto& f) { return f.drop == Drop::Loss && f.copies == 0; }),
            1000);
  settings = {};
  settings.block = true;
  EXPECT_EQ(countIf(fates(settings, {1, 0, 0}, 1000),
                    [](const auto& f) { return f.drop == Drop::Blocked && f.copies == 0; }),
            1000);
  settings = {};
  settings.burst_every_ns = settings.burst_ns = kMs;  // no gap at all
  EXPECT_EQ(countIf(fates(settings, {1, 0, 0}, 1000), [](const auto& f) { return f.drop == Drop::Burst; }),
            1000);
  settings = {};
  settings.duplicate = settings.corrupt = 1.0;
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{65507}}) {
    for (const DatagramFate& fate : fates(settings, {1, 0, 0}, 1000, kMs, bytes)) {
      EXPECT_EQ(fate.copies, 2);
      EXPECT_EQ(fate.leaves_ns[0], fate.leaves_ns[1]);
      ASSERT_TRUE(fate.flipped_bit);
      EXPECT_LT(*fate.flipped_bit, 8 * bytes);
    }
  }
  for (const DatagramFate& fate : fates(settings, {1, 0, 0}, 100, kMs, 0)) EXPECT_FALSE(fate.flipped_bit);
}

TEST(Impairment, AnyBitMayBeFlipped) {
  ImpairmentSettings settings;
  settings.corrupt = 1.0;
  std::array<int, 16> counts{};
  constexpr int kCount = 16'000;
  for (const DatagramFate& fate : fates(settings, {2, 0, 0}, kCount, kMs, 2))
    ++counts.at(fate.flipped_bit.value());
  for (const int count : counts) expectBinomial(count, kCount, 1.0 / 16.0);
}

TEST(Impairment, ChangesHoldFromThenOnAndKeepTheOrder) {
  ImpairmentSettings slow;
  slow.delay_ns = 100 * kMs;
  Impairment impairment({1, 0, 0}, slow, 0);
  EXPECT_EQ(impairment.pass(kMs, kBytes).leaves_ns[0], 101 * kMs);
  impairment.change({}, 2 * kMs);
  EXPECT_EQ(impairment.pass(2 * kMs, kBytes).leaves_ns[0], 101 * kMs);
  EXPECT_EQ(impairment.pass(200 * kMs, kBytes).leaves_ns[0], 200 * kMs);
  ImpairmentSettings blocked;
  blocked.block = true;
  impairment.change(blocked, 200 * kMs);
  EXPECT_EQ(impairment.pass(200 * kMs, kBytes).drop, Drop::Blocked);
}

TEST(Impairment, OtherSettingsLeaveTheBurstsAlone) {
  ImpairmentSettings settings;
  settings.burst_every_ns = 50 * kMs;
  settings.burst_ns = 10 * kMs;
  const auto without_change = fates(settings, {9, 0, 0}, 1000);
  Impairment impairment({9, 0, 0}, settings, 0);
  for (std::size_t i = 0; i < without_change.size(); ++i) {
    const std::int64_t now = static_cast<std::int64_t>(i) * kMs;
    settings.delay_ns = now % 7;
    impairment.change(settings, now);
    EXPECT_EQ(impairment.pass(now, kBytes).drop, without_change[i].drop);
  }
}

TEST(Impairment, ALongSilenceCostsLittle) {
  ImpairmentSettings settings;
  settings.burst_every_ns = kMs;
  settings.burst_ns = 1;
  Impairment impairment({1, 0, 0}, settings, 0);
  EXPECT_EQ(impairment.pass(3600 * 1000 * kMs, kBytes).leaves_ns[0], 3600 * 1000 * kMs);
}

TEST(ImpairmentDeathTest, TimeDoesNotGoBack) {
  Impairment impairment({1, 0, 0}, {}, 1000);
  EXPECT_DEBUG_DEATH(impairment.pass(999, kBytes), "arrival_ns >= newest_ns_");
}

TEST(ImpairmentSettings, FaultsAreNamed) {
  EXPECT_EQ(faultOf({}), "");
  const auto fault = [](auto set) {
    ImpairmentSettings settings;
    set(settings);
    return faultOf(settings);
  };
  const auto names = [](const std::string& text, const char* word) {
    return text.find(word) != std::string::npos;
  };
  for (const double wrong : {-0.01, 1.01, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(names(fault([&](auto& s) { s.loss = wrong; }), "loss"));
    EXPECT_TRUE(names(fault([&](auto& s) { s.duplicate = wrong; }), "duplicate"));
    EXPECT_TRUE(names(fault([&](auto& s) { s.corrupt = wrong; }), "corrupt"));
  }
  EXPECT_TRUE(names(fault([](auto& s) { s.delay_ns = -1; }), "hour"));
  EXPECT_TRUE(names(fault([](auto& s) { s.jitter_ns = std::numeric_limits<std::int64_t>::max(); }), "hour"));
  EXPECT_TRUE(names(fault([](auto& s) { s.burst_every_ns = kMs - 1; }), "1 ms"));
  EXPECT_TRUE(names(fault([](auto& s) { s.burst_every_ns = kMs, s.burst_ns = kMs + 1; }), "no longer"));
  EXPECT_EQ(fault([](auto& s) { s.burst_ns = 20 * kMs; }), "");  // none of that length happen
}

}  // namespace
}  // namespace coherency
