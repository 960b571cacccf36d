#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace coherency {

/// Seeded choices that are the same with every standard library (std's distributions are not).
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}

  double between(double low, double high);
  bool happens(double probability) { return between(0.0, 1.0) < probability; }
  /// 0 .. count - 1. Precondition: count > 0.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

 private:
  std::mt19937_64 engine_;
};

/// Band-limited noise: a uniform cubic B-spline over seeded random values, `knots_per_s` a second; -1..1, two
/// times continuously differentiable, and a function of time alone. Its power lies below about half the knot
/// rate.
class SmoothNoise {
 public:
  SmoothNoise(std::uint64_t seed, std::uint64_t channel, double knots_per_s);
  double at(double time_s) const;

 private:
  double knot(std::int64_t number) const;

  std::uint64_t key_;
  double rate_;
};

/// Uniform cubic B-spline between its two middle control values; s in 0..1.
double cubicBSpline(double before, double first, double second, double after, double s);

}  // namespace coherency
