#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/FixedPoint.h"
#include "common/math/Trigonometry.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

/// Distance from the truth (80-bit long double) in units of the result's last place; near zeros, of 2^-60.
double unitsOff(double value, long double truth) {
  const double ulp =
      std::nextafter(std::abs(static_cast<double>(truth)), 2.0) - std::abs(static_cast<double>(truth));
  return static_cast<double>(std::abs(static_cast<long double>(value) - truth)) / std::max(ulp, 0x1p-60);
}

void expectTrue(double angle) {
  const SineCosine sc = sineCosine(angle);
  RC_ASSERT(unitsOff(sc.sine, std::sin(static_cast<long double>(angle))) <= 1.0);
  RC_ASSERT(unitsOff(sc.cosine, std::cos(static_cast<long double>(angle))) <= 1.0);
}

RC_GTEST_PROP(SineCosine, AreWithinOneUnitInTheLastPlace, ()) {
  for (int i = 0; i < 100; ++i) expectTrue(random::real(-10.0, 10.0));
}

RC_GTEST_PROP(SineCosine, AlsoOfManyTurns, ()) {
  for (int i = 0; i < 100; ++i) expectTrue(random::real(-1e7, 1e7));
}

RC_GTEST_PROP(SineCosine, AlsoNearWholeQuarters, ()) {
  const double quarters = *rc::gen::inRange(-4'000'000, 4'000'000);
  expectTrue(quarters * (kTurn / 4.0) + std::pow(10.0, random::real(-12.0, -1.0)));
  expectTrue(quarters * (kTurn / 4.0));
}

RC_GTEST_PROP(SineCosine, ObeyTheirSymmetries, ()) {
  const double angle = random::real(-7.0, 7.0);
  const SineCosine a = sineCosine(angle);
  const SineCosine b = sineCosine(-angle);
  RC_ASSERT(a.sine == -b.sine);
  RC_ASSERT(a.cosine == b.cosine);
  RC_ASSERT(std::abs(a.sine * a.sine + a.cosine * a.cosine - 1.0) < 4e-16);
}

RC_GTEST_PROP(SineCosine, BeyondTenMillionAreOfTheRemainder, ()) {
  const double angle = random::real(1e7, 1e15);
  const SineCosine a = sineCosine(angle);
  const SineCosine b = sineCosine(std::remainder(angle, kTurn));
  RC_ASSERT(a.sine == b.sine);
  RC_ASSERT(a.cosine == b.cosine);
}

TEST(SineCosine, OfNothingAndOfNoNumber) {
  EXPECT_EQ(sineCosine(0.0).sine, 0.0);
  EXPECT_EQ(sineCosine(0.0).cosine, 1.0);
  for (const double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_TRUE(std::isnan(sineCosine(bad).sine));
    EXPECT_TRUE(std::isnan(sineCosine(bad).cosine));
  }
}

TEST(SineCosine, AreTheSameBitsEverywhere) {
  // FNV-1a over the bits of a hundred thousand of each: frozen, since replicated state depends on them.
  std::uint64_t hash = 0xCBF29CE484222325U;
  const auto add = [&hash](double value) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001B3U;
  };
  for (std::int32_t i = -50'000; i < 50'000; ++i) {
    const SineCosine sc = sineCosine(i * 42'949 * kAngleUnit);
    add(sc.sine);
    add(sc.cosine);
  }
  EXPECT_EQ(hash, 0xFB12C8AD8BD5A507U);
}

}  // namespace
}  // namespace coherency
