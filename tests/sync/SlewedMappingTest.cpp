#include <cstdint>
#include <cstdlib>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/sync/SlewedMapping.h"

namespace coherency {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(SlewedMapping, TheFirstEstimateIsTakenAtOnce) {
  SlewedMapping mapping;
  mapping.steer({1000}, -700, 0.0);
  EXPECT_EQ(mapping.toServer({1000}).ns, 300);
  EXPECT_EQ(mapping.toServer({0}).ns, -700);
  EXPECT_EQ(mapping.toClient({300}).ns, 1000);
}

TEST(SlewedMapping, FollowsTheSkew) {
  SlewedMapping mapping;
  mapping.steer({0}, 0, 200e-6);
  EXPECT_EQ(mapping.toServer({100 * kMs}).ns, 100 * kMs + 20'000);
}

TEST(SlewedMapping, SpreadsASmallDifferenceOver20Ms) {
  SlewedMapping mapping;
  mapping.steer({0}, 0, 0.0);
  mapping.steer({0}, 1000, 0.0);
  EXPECT_EQ(mapping.toServer({0}).ns, 0);
  EXPECT_EQ(mapping.toServer({10 * kMs}).ns, 10 * kMs + 500);
  EXPECT_EQ(mapping.toServer({20 * kMs}).ns, 20 * kMs + 1000);
  EXPECT_EQ(mapping.toServer({900 * kMs}).ns, 900 * kMs + 1000);
}

TEST(SlewedMapping, NeedsTwentyTimesALargeDifference) {
  for (const std::int64_t sign : {-1, 1}) {
    SlewedMapping mapping;
    mapping.steer({0}, 0, 0.0);
    mapping.steer({0}, sign * 50 * kMs, 0.0);
    EXPECT_EQ(mapping.toServer({500 * kMs}).ns, 500 * kMs + sign * 25 * kMs);
    EXPECT_EQ(mapping.toServer({1000 * kMs}).ns, 1000 * kMs + sign * 50 * kMs);
    EXPECT_EQ(mapping.toServer({2000 * kMs}).ns, 2000 * kMs + sign * 50 * kMs);
  }
}

TEST(SlewedMapping, RemembersWhatWasInForceBefore) {
  SlewedMapping mapping;
  mapping.steer({0}, 0, 0.0);
  mapping.steer({0}, 1000, 0.0);
  mapping.steer({100 * kMs}, 5000, 0.0);  // after it had arrived
  EXPECT_EQ(mapping.toServer({50 * kMs}).ns, 50 * kMs + 1000);
  EXPECT_EQ(mapping.toClient({50 * kMs + 1000}).ns, 50 * kMs);
  mapping.steer({110 * kMs}, 5000, 0.0);  // on its way
  EXPECT_EQ(mapping.toServer({105 * kMs}).ns, 105 * kMs + 2000);
}

TEST(SlewedMapping, JumpsOverMoreThanASecondOnly) {
  SlewedMapping mapping;
  mapping.steer({0}, 0, 0.0);
  mapping.steer({5}, 1'000'000'000, 0.0);
  EXPECT_EQ(mapping.toServer({5}).ns, 5);
  mapping.steer({5}, 1'000'000'001, 0.0);
  EXPECT_EQ(mapping.toServer({5}).ns, 5 + 1'000'000'001);
}

// A reader looks at arbitrary moments while estimates come.
RC_GTEST_PROP(SlewedMapping, NeverStepsAndInverts, ()) {
  SlewedMapping mapping;
  std::int64_t now = *rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 60);
  const std::int64_t start = *rc::gen::inRange<std::int64_t>(-(std::int64_t{1} << 59), std::int64_t{1} << 59);
  mapping.steer({now}, start, 0.0);
  const int estimates = *rc::gen::inRange(1, 20);
  for (int i = 0; i < estimates; ++i) {
    const auto magnitude = *rc::gen::element<std::int64_t>(10, 1000, 100'000, 10 * kMs, 400 * kMs);
    mapping.steer({now}, start + *rc::gen::inRange(-magnitude, magnitude + 1),
                  *rc::gen::inRange(-300, 301) * 1e-6);
    const int looks = *rc::gen::inRange(1, 10);
    for (int look = 0; look < looks; ++look) {
      const auto pause =
          *rc::gen::inRange<std::int64_t>(0, *rc::gen::element<std::int64_t>(10, kMs, 300 * kMs));
      const std::int64_t before = mapping.toServer({now}).ns;
      now += pause;
      const std::int64_t after = mapping.toServer({now}).ns;
      RC_ASSERT(after >= before);
      const auto limit = static_cast<std::int64_t>(SlewedMapping::kMaxRate * static_cast<double>(pause));
      RC_ASSERT(std::abs(after - before - pause) <= limit + 2);
      RC_ASSERT(std::abs(mapping.toClient({after}).ns - now) <= 1);
    }
  }
}

}  // namespace
}  // namespace coherency
