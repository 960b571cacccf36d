#include "common/math/Trigonometry.h"

#include <cmath>
#include <limits>

#include "common/math/FixedPoint.h"

namespace coherency {
namespace {

// pi / 2 in three parts: the first two have 30 bits, so that their products with up to 2^23 quarter turns are
// exact (Cody and Waite, Software Manual for the Elementary Functions, 1980).
constexpr double kQuarter1 = 0x1.921fb54000000p+0;
constexpr double kQuarter2 = 0x1.10b4611800000p-30;
constexpr double kQuarter3 = 0x1.313198a2e0370p-61;
constexpr double kQuartersInOne = 0.63661977236758134308;  // 2 / pi
constexpr double kFarthest = 1e7;

// Taylor's series for the angle r + rest, |r| <= pi / 4: the first term left out is below 2^-58 of the
// result, and of the tiny rest only the first power counts.
double sineNear(double r, double rest) {
  const double z = r * r;
  const double series =
      -1.0 / 6.0 +
      z * (1.0 / 120.0 +
           z * (-1.0 / 5040.0 +
                z * (1.0 / 362880.0 + z * (-1.0 / 39916800.0 +
                                           z * (1.0 / 6227020800.0 + z * (-1.0 / 1307674368000.0 +
                                                                          z * (1.0 / 355687428096000.0)))))));
  return r + (r * z * series + rest * (1.0 - 0.5 * z));
}

double cosineNear(double r, double rest) {
  const double z = r * r;
  const double series =
      1.0 / 24.0 +
      z * (-1.0 / 720.0 +
           z * (1.0 / 40320.0 +
                z * (-1.0 / 3628800.0 +
                     z * (1.0 / 479001600.0 + z * (-1.0 / 87178291200.0 + z * (1.0 / 20922789888000.0))))));
  const double half = 0.5 * z;
  const double first = 1.0 - half;
  return first + ((1.0 - first - half) + (z * z * series - r * rest));  // with what rounding `first` lost
}

}  // namespace

SineCosine sineCosine(double angle_rad) {
  if (!std::isfinite(angle_rad)) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    return {kNan, kNan};
  }
  const double angle = std::abs(angle_rad) <= kFarthest ? angle_rad : std::remainder(angle_rad, kTurn);
  const double quarters = std::nearbyint(angle * kQuartersInOne);
  const double near = angle - quarters * kQuarter1;  // exact, and so is the next product
  const double middle = quarters * kQuarter2;
  const double nearer = near - middle;
  const double last = quarters * kQuarter3 - ((near - nearer) - middle);
  const double r = nearer - last;
  const double rest = (nearer - r) - last;
  const double s = sineNear(r, rest);
  const double c = cosineNear(r, rest);
  switch (static_cast<int>(quarters) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace coherency
