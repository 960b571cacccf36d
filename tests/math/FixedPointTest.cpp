#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/FixedPoint.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr auto kMin32 = std::numeric_limits<std::int32_t>::min();
constexpr auto kMax32 = std::numeric_limits<std::int32_t>::max();

RC_GTEST_PROP(FixedPoint, EveryMicrometreComesBack, (std::int32_t um)) {
  RC_ASSERT(micrometresFromMetres(metresFromMicrometres(um)) == um);
}

RC_GTEST_PROP(FixedPoint, EveryAngleUnitComesBack, (std::int32_t units)) {
  RC_ASSERT(unitsFromRadians(radiansFromUnits(units)) == units);
}

RC_GTEST_PROP(FixedPoint, EveryRatioUnitComesBack, (std::int32_t units)) {
  RC_ASSERT(unitsFromRatio(ratioFromUnits(units)) == units);
}

RC_GTEST_PROP(FixedPoint, EveryNanometreWithinAThousandKilometresComesBack, ()) {
  constexpr std::int64_t kReach = 1'000'000'000'000'000;
  const auto nm = *rc::gen::inRange<std::int64_t>(-kReach, kReach + 1);
  RC_ASSERT(nanometresFromMetres(metresFromNanometres(nm)) == nm);
}

TEST(FixedPoint, TheExtremesComeBack) {
  for (const auto extreme : {kMin32, kMin32 + 1, -1, 0, 1, kMax32 - 1, kMax32}) {
    EXPECT_EQ(micrometresFromMetres(metresFromMicrometres(extreme)), extreme);
    EXPECT_EQ(unitsFromRadians(radiansFromUnits(extreme)), extreme);
    EXPECT_EQ(unitsFromRatio(ratioFromUnits(extreme)), extreme);
  }
}

TEST(FixedPoint, RoundsToTheNearestUnitHalvesAwayFromZero) {
  EXPECT_EQ(micrometresFromMetres(1.4e-6), 1);
  EXPECT_EQ(micrometresFromMetres(0.5e-6), 1);
  EXPECT_EQ(micrometresFromMetres(-0.5e-6), -1);
  EXPECT_EQ(micrometresFromMetres(-0.49e-6), 0);
  EXPECT_EQ(nanometresFromMetres(2.5e-9), 3);
  EXPECT_EQ(unitsFromRatio(1.5 * kRatioUnit), 2);
  EXPECT_EQ(unitsFromRatio(1.0), 1 << 30);
  EXPECT_EQ(unitsFromRadians(kTurn / 4.0), 1 << 30);
}

RC_GTEST_PROP(FixedPoint, WholeTurnsDropOutExactly, (std::int32_t units)) {
  const auto turns = *rc::gen::inRange<int>(-1'000'000, 1'000'001);
  // fma rounds the sum once, so what is tested is the wrap and not the making of its input.
  const double radians = std::fma(static_cast<double>(turns), kTurn, radiansFromUnits(units));
  RC_ASSERT(unitsFromRadians(radians) == units);
}

TEST(FixedPoint, AMillionTurnsAreNoTurn) {
  for (const double turns : {1.0, -1.0, 3.0, 1e3, -1e6, 1e6})
    EXPECT_EQ(unitsFromRadians(turns * kTurn), 0) << turns;
}

TEST(FixedPoint, HalfATurnWrapsToMinusHalfATurn) {
  EXPECT_EQ(unitsFromRadians(kTurn / 2.0), kMin32);
  EXPECT_EQ(unitsFromRadians(-kTurn / 2.0), kMin32);
  EXPECT_EQ(unitsFromRadians(kTurn / 2.0 - kAngleUnit), kMax32);
  EXPECT_EQ(unitsFromRadians(kTurn / 2.0 + kAngleUnit), kMin32 + 1);
  EXPECT_LT(radiansFromUnits(kMax32), kTurn / 2.0);
}

RC_GTEST_PROP(FixedPoint, AnyFiniteAngleIsTaken, (double radians)) {
  RC_PRE(std::isfinite(radians));
  const double back = radiansFromUnits(unitsFromRadians(radians));
  // The same direction, to half a unit and the rounding of the remainder.
  RC_ASSERT(std::abs(std::remainder(std::remainder(radians, kTurn) - back, kTurn)) <=
            0.5 * kAngleUnit + 1e-15);
}

TEST(FixedPoint, RefusesWhatDoesNotFitAndSaysWhy) {
  EXPECT_THROW(micrometresFromMetres(2147.483648), std::range_error);
  EXPECT_NO_THROW(micrometresFromMetres(2147.483647));
  EXPECT_NO_THROW(micrometresFromMetres(-2147.483648));
  EXPECT_THROW(micrometresFromMetres(-2147.483649), std::range_error);
  EXPECT_THROW(nanometresFromMetres(9.3e9), std::range_error);
  EXPECT_NO_THROW(nanometresFromMetres(-9.2e9));
  EXPECT_THROW(unitsFromRatio(2.0), std::range_error);
  EXPECT_EQ(unitsFromRatio(-2.0), kMin32);
  try {
    micrometresFromMetres(3000.5);
    FAIL();
  } catch (const std::range_error& error) {
    EXPECT_NE(std::string(error.what()).find("3000.5"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("2147.48"), std::string::npos) << error.what();
  }
}

TEST(FixedPoint, RefusesWhatIsNotANumber) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    EXPECT_THROW(micrometresFromMetres(bad), std::range_error);
    EXPECT_THROW(nanometresFromMetres(bad), std::range_error);
    EXPECT_THROW(unitsFromRatio(bad), std::range_error);
    EXPECT_THROW(unitsFromRadians(bad), std::range_error);
  }
}

}  // namespace
}  // namespace coherency
