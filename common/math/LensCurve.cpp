#include "common/math/LensCurve.h"

#include <algorithm>
#include <cmath>

namespace coherency {
namespace {

using Coefficients = std::array<double, 5>;

double value(const Coefficients& c, double x) {
  return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4])));
}

/// Of c[0] + c[1] x + ... c[4] x^4 on 0..end.
Coefficients bernstein(Coefficients c, double end) {
  constexpr double kBinomial[5][5] = {
      {1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}};
  Coefficients b{};
  double power = 1.0;
  for (std::size_t i = 0; i < c.size(); ++i, power *= end)
    for (std::size_t j = i; j < b.size(); ++j) b[j] += kBinomial[j][i] / kBinomial[4][i] * c[i] * power;
  return b;
}

/// De Casteljau's halves: `b` becomes the first, what is returned is the second.
Coefficients split(Coefficients& b) {
  Coefficients second = b;
  Coefficients first{};
  for (std::size_t level = 0; level < b.size(); ++level) {
    first[level] = second[0];
    for (std::size_t i = 0; i + 1 < b.size() - level; ++i) second[i] = 0.5 * (second[i] + second[i + 1]);
  }
  b = first;
  return second;
}

/// Says no, too, of what touches zero, or comes nearer than `halvings` can tell.
bool positive(Coefficients b, int halvings = 40) {
  if (!(b.front() > 0.0 && b.back() > 0.0)) return false;
  if (std::all_of(b.begin(), b.end(), [](double x) { return x > 0.0; })) return true;
  if (halvings == 0) return false;
  const Coefficients second = split(b);
  return positive(b, halvings - 1) && positive(second, halvings - 1);
}

}  // namespace

double LensCurve::tangent(double r) const {
  const double s = value(c, r * r);
  return reciprocal ? r / s : r * s;
}

/// With q = r^2 and s' over q: (r s)' = s + 2 q s', and (r / s)' = (s - 2 q s') / s^2.
double LensCurve::slope(double r) const {
  const double q = r * r;
  const double s = value(c, q);
  const double bent = 2.0 * q * value({c[1], 2.0 * c[2], 3.0 * c[3], 4.0 * c[4], 0.0}, q);
  return reciprocal ? (s - bent) / (s * s) : s + bent;
}

bool LensCurve::risesUpTo(double r_max) const {
  Coefficients slope_of{};
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double twice = 2.0 * static_cast<double>(i);
    slope_of[i] = c[i] * (reciprocal ? 1.0 - twice : 1.0 + twice);
  }
  const double end = r_max * r_max;
  return positive(bernstein(slope_of, end)) && (!reciprocal || positive(bernstein(c, end)));
}

std::optional<double> LensCurve::radius(double wanted, double r_max) const {
  if (!(wanted >= 0.0 && wanted <= tangent(r_max))) return std::nullopt;
  double low = 0.0;
  double high = r_max;
  double r = 0.5 * r_max;
  for (int i = 0; i < 200 && high - low > 1e-15 * r_max; ++i) {
    const double off = tangent(r) - wanted;
    if (off == 0.0) return r;
    (off > 0.0 ? high : low) = r;
    const double newton = r - off / slope(r);
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(next - r) <= 1e-16 * r_max) return next;
    r = next;
  }
  return r;
}

}  // namespace coherency
