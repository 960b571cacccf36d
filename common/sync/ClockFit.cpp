#include "common/sync/ClockFit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

namespace coherency {
namespace {

constexpr std::int64_t kPieceNs = 1'000'000'000;
constexpr std::int64_t kLeastBaselineNs = 2'000'000'000;
constexpr std::int64_t kMemoryNs = 32 * kPieceNs;
constexpr double kErrorOfShortest = 0.1;  // of its round trip: even the best ways there and back are unequal
constexpr double kLeastErrorUs = 1.0;

double us(std::int64_t ns) {
  return static_cast<double>(ns) * 1e-3;
}

}  // namespace

/// Of time in seconds after now, and offset in us from the newest point's, so that a skew is in ppm.
struct ClockFit::Sums {
  double weight = 0.0, time = 0.0, offset = 0.0, time_time = 0.0, time_offset = 0.0;

  void add(double t, double y, double error) {
    const double w = 1.0 / (error * error);
    weight += w;
    time += w * t;
    offset += w * y;
    time_time += w * t * t;
    time_offset += w * t * y;
  }
  double skew(double skew_error) const {
    const double covariance = time_offset - time * offset / weight;
    const double variance = std::max(0.0, time_time - time * time / weight);
    return covariance / (variance + 1.0 / (skew_error * skew_error));
  }
  double offsetNow(double skew) const { return (offset - skew * time) / weight; }
};

void ClockFit::add(const ClockExchange& exchange) {
  assert(exchange.possible());
  const std::int64_t twice_offset = (exchange.t1.ns - exchange.t0.ns) + (exchange.t2.ns - exchange.t3.ns);
  const Point fresh{exchange.t0 + (exchange.t3 - exchange.t0) / 2, twice_offset / 2, exchange.roundTripNs()};
  if (pieces_ == 0 || exchange.t3 >= piece_ends_) {
    points_[pieces_++ % kPieces] = fresh;
    piece_ends_ = exchange.t3 + kPieceNs;
    return;
  }
  Point& shortest = points_[(pieces_ - 1) % kPieces];
  if (fresh.round_trip_ns <= shortest.round_trip_ns) shortest = fresh;
}

ClockFit::Line ClockFit::at(ClientTime now) const {
  assert(pieces_ > 0);
  const Point& newest = points_[(pieces_ - 1) % kPieces];
  const auto recent = [&](const Point& p) { return newest.at - p.at <= kMemoryNs; };
  const auto points = std::span(points_).first(std::min(pieces_, kPieces));
  std::int64_t shortest_ns = newest.round_trip_ns;
  std::int64_t baseline_ns = 0;
  for (const Point& p : points) {
    if (!recent(p)) continue;
    shortest_ns = std::min(shortest_ns, p.round_trip_ns);
    baseline_ns = std::max(baseline_ns, newest.at - p.at);
  }
  // Below, a skew would be noise; old points count less instead, as the clocks may have drifted since.
  const bool skewed = baseline_ns >= kLeastBaselineNs;
  Sums sums;
  for (const Point& p : points) {
    if (!recent(p)) continue;
    const double age = us(now - p.at) * 1e-6;
    const double at_best = std::max(kLeastErrorUs, kErrorOfShortest * us(shortest_ns));
    const double delayed = us(p.round_trip_ns - shortest_ns) / 2;
    const double drifted = skewed ? 0.0 : age * likelySkewPpm();
    sums.add(-age, us(p.offset_ns - newest.offset_ns), at_best + delayed + drifted);
  }
  const double skew_ppm = skewed ? std::clamp(sums.skew(likelySkewPpm()), -drift_ppm_, drift_ppm_) : 0.0;
  return {newest.offset_ns + std::llround(sums.offsetNow(skew_ppm) * 1e3), skew_ppm * 1e-6};
}

}  // namespace coherency
