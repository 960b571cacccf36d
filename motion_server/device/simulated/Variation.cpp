#include "motion_server/device/simulated/Variation.h"

#include <cmath>

namespace coherency {

namespace {

constexpr double kTo01 = 0x1.0p-53;

/// splitmix64 (Steele, Lea, Flood 2014): a well mixed function of its argument.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31);
}

}  // namespace

double Chance::between(double low, double high) {
  return low + (high - low) * (static_cast<double>(engine_() >> 11) * kTo01);
}

SmoothNoise::SmoothNoise(std::uint64_t seed, std::uint64_t channel, double knots_per_s)
    : key_(mixed(mixed(seed) ^ channel)), rate_(knots_per_s) {}

double SmoothNoise::knot(std::int64_t number) const {
  return static_cast<double>(mixed(key_ ^ static_cast<std::uint64_t>(number)) >> 11) * kTo01 * 2.0 - 1.0;
}

double SmoothNoise::at(double time_s) const {
  const double position = time_s * rate_;
  const double whole = std::floor(position);
  const auto n = static_cast<std::int64_t>(whole);
  return cubicBSpline(knot(n - 1), knot(n), knot(n + 1), knot(n + 2), position - whole);
}

double cubicBSpline(double before, double first, double second, double after, double s) {
  const double r = 1.0 - s;
  return (r * r * r * before + (4.0 + s * s * (3.0 * s - 6.0)) * first +
          (4.0 + r * r * (3.0 * r - 6.0)) * second + s * s * s * after) /
         6.0;
}

}  // namespace coherency
