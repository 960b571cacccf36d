#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "motion_server/device/simulated/MinimumJerk.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

RC_GTEST_PROP(MinimumJerk, BeginsInItsStateAndEndsAtRest, ()) {
  const MinimumJerk::State from{random::real(-3, 3), random::real(-3, 3), random::real(-9, 9)};
  const double goal = random::real(-3, 3);
  const double duration = random::real(0.2, 3.0);
  const MinimumJerk way(from, goal, 5.0, duration);
  const auto begin = way.at(5.0);
  RC_ASSERT(std::abs(begin.position - from.position) < 1e-9);
  RC_ASSERT(std::abs(begin.velocity - from.velocity) < 1e-9);
  RC_ASSERT(std::abs(begin.acceleration - from.acceleration) < 1e-8);
  const auto end = way.at(5.0 + duration - 1e-9);
  RC_ASSERT(std::abs(end.position - goal) < 1e-6);
  RC_ASSERT(std::abs(end.velocity) < 1e-5);
  RC_ASSERT(std::abs(end.acceleration) < 1e-3);
  RC_ASSERT(std::abs(way.at(99.0).position - goal) < 1e-9);
}

RC_GTEST_PROP(MinimumJerk, DerivativesAreThoseOfThePosition, ()) {
  const MinimumJerk way({random::real(-1, 1), random::real(-1, 1), random::real(-1, 1)}, random::real(-1, 1),
                        0.0, 1.5);
  const double t = random::real(0.1, 1.4);
  constexpr double h = 1e-4;
  const auto state = way.at(t);
  RC_ASSERT(std::abs((way.at(t + h).position - way.at(t - h).position) / (2 * h) - state.velocity) < 1e-5);
  RC_ASSERT(std::abs((way.at(t + h).velocity - way.at(t - h).velocity) / (2 * h) - state.acceleration) <
            1e-5);
}

TEST(MinimumJerk, PeakSpeedIsThatOfFlashAndHogan) {
  const MinimumJerk way({}, 1.0, 0.0, 1.0);
  EXPECT_NEAR(way.at(0.5).velocity, 1.875, 1e-12);
  EXPECT_NEAR(minimumJerk(0.5), 0.5, 1e-12);
  EXPECT_EQ(minimumJerk(-1.0), 0.0);
  EXPECT_EQ(minimumJerk(2.0), 1.0);
}

RC_GTEST_PROP(Follower, DoesNotDependOnTheStepsItIsTakenIn, ()) {
  Follower fine(8.0, random::real(-1, 1));
  Follower coarse = fine;
  const double goal = random::real(-1, 1);
  for (int i = 0; i < 100; ++i) fine.follow(goal, 0.003);
  coarse.follow(goal, 0.3);
  RC_ASSERT(std::abs(fine.value() - coarse.value()) < 1e-9);
  RC_ASSERT(std::abs(fine.rate() - coarse.rate()) < 1e-8);
}

TEST(Follower, ArrivesWithoutOvershoot) {
  Follower follower(8.0);
  for (int i = 0; i < 3000; ++i) {
    follower.follow(1.0, 0.001);
    ASSERT_LE(follower.value(), 1.0);
  }
  EXPECT_NEAR(follower.value(), 1.0, 1e-6);
}

}  // namespace
}  // namespace coherency
