#include "common/math/FixedPoint.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace coherency {
namespace {

/// `scaled` rounded; `value` and `what` are for the message only.
template <class Integer>
Integer rounded(double scaled, double value, const char* what) {
  // 2^31 and 2^63 are doubles; the largest int64 is not.
  const double limit = std::ldexp(1.0, std::numeric_limits<Integer>::digits);
  const double nearest = std::round(scaled);
  if (!(nearest >= -limit && nearest < limit)) {
    std::ostringstream text;
    text.precision(17);
    text << what << ": " << value << " does not fit in " << std::numeric_limits<Integer>::digits + 1
         << " bits; at most " << limit * (value / scaled) << " in magnitude";
    if (!std::isfinite(value)) text.str(std::string(what) + ": not a finite number");
    throw std::range_error(text.str());
  }
  return static_cast<Integer>(nearest);
}

}  // namespace

std::int32_t micrometresFromMetres(double metres) {
  return rounded<std::int32_t>(metres * 1e6, metres, "length in metres");
}

std::int64_t nanometresFromMetres(double metres) {
  return rounded<std::int64_t>(metres * 1e9, metres, "length in metres");
}

std::int32_t unitsFromRatio(double ratio) {
  return rounded<std::int32_t>(ratio / kRatioUnit, ratio, "ratio");
}

std::int32_t unitsFromRadians(double radians) {
  if (!std::isfinite(radians)) throw std::range_error("angle in radians: not a finite number");
  // IEEE remainder is exact: what is left of any number of turns is not rounded.
  const auto units = static_cast<std::int64_t>(std::round(std::remainder(radians, kTurn) / kAngleUnit));
  return static_cast<std::int32_t>(
      static_cast<std::uint32_t>(units));  // half a turn wraps to minus half a turn
}

}  // namespace coherency
