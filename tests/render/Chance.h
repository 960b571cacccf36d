#pragma once

#include <cmath>
#include <cstddef>
#include <random>

#include "common/math/Coord3.h"

namespace coherency {

/// The same values in every run.
class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  double magnitude(double low, double high) { return std::pow(10.0, between(low, high)); }
  Coord3 in(const Coord3& half) {
    return {between(-half.x, half.x), between(-half.y, half.y), between(-half.z, half.z)};
  }
  Coord3 in(double size) { return in(Coord3{size, size, size}); }
  Coord3 direction() {
    Coord3 v;
    do v = in(1.0);
    while (norm(v) > 1.0 || norm(v) < 1e-3);
    return normalized(v);
  }
  std::size_t oneOf(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace coherency
