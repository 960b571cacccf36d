#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "motion_server/device/simulated/Variation.h"

namespace coherency {
namespace {

TEST(Chance, IsTheSameWithEveryStandardLibrary) {
  // mt19937_64's 10000th value for its default seed is in the standard: [rand.predef].
  Chance chance(5489);
  for (int i = 0; i < 9999; ++i) chance.below(2);
  EXPECT_EQ(chance.below(1'000'000'007), 9981545732273789042U % 1'000'000'007);
}

TEST(Chance, CoversItsRange) {
  Chance chance(3);
  double low = 9.0, high = -9.0;
  std::set<std::size_t> numbers;
  for (int i = 0; i < 10'000; ++i) {
    const double x = chance.between(-2.0, 3.0);
    low = std::min(low, x), high = std::max(high, x);
    numbers.insert(chance.below(7));
  }
  EXPECT_GE(low, -2.0);
  EXPECT_LT(low, -1.99);
  EXPECT_LT(high, 3.0);
  EXPECT_GT(high, 2.99);
  EXPECT_EQ(numbers.size(), 7u);
}

TEST(SmoothNoise, IsBoundedSmoothAndNeverRepeats) {
  const SmoothNoise noise(1, 2, 2.0);
  constexpr double h = 1e-3;
  double mean = 0.0, square = 0.0;
  for (int i = 0; i < 100'000; ++i) {
    const double t = i * h;
    const double x = noise.at(t);
    ASSERT_LE(std::abs(x), 1.0);
    const double velocity = (noise.at(t + h) - x) / h;
    const double acceleration = (noise.at(t + h) - 2 * x + noise.at(t - h)) / (h * h);
    ASSERT_LE(std::abs(velocity), 2.0 * 2.0);  // knots differ by 2 at most, 2 a second
    ASSERT_LE(std::abs(acceleration),
              4.0 * 4.0 + 1e-3);  // second difference of knots, times the rate squared
    mean += x / 1e5, square += x * x / 1e5;
  }
  EXPECT_LT(std::abs(mean), 0.1);
  EXPECT_GT(square, 0.05);
}

TEST(SmoothNoise, ChannelsAndSeedsDiffer) {
  const SmoothNoise a(1, 2, 2.0), again(1, 2, 2.0), channel(1, 3, 2.0), seed(2, 2, 2.0);
  double different_channel = 0.0, different_seed = 0.0;
  for (double t = 0; t < 20; t += 0.1) {
    ASSERT_EQ(a.at(t), again.at(t));
    different_channel = std::max(different_channel, std::abs(a.at(t) - channel.at(t)));
    different_seed = std::max(different_seed, std::abs(a.at(t) - seed.at(t)));
  }
  EXPECT_GT(different_channel, 0.3);
  EXPECT_GT(different_seed, 0.3);
}

}  // namespace
}  // namespace coherency
