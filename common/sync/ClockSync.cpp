#include "common/sync/ClockSync.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace coherency {

ClockSync::ClockSync(double drift_ppm) : drift_ppm_(drift_ppm), interval_(drift_ppm), fit_(drift_ppm) {
  assert(drift_ppm >= 0.0 && drift_ppm <= 1000.0);
}

bool ClockSync::add(const ClockExchange& exchange) {
  if (!exchange.possible() || (stepped_ && exchange.t0 < *stepped_)) return false;
  if (!interval_.tighten(exchange)) {
    if (exchange.t0 < asked_) return false;  // late news of how the clocks were before
    stepped_ = exchange.t0;
    interval_ = ClockInterval(drift_ppm_);
    interval_.tighten(exchange);
    fit_ = ClockFit(drift_ppm_);
  }
  asked_ = std::max(asked_, exchange.t0);
  answered_ = std::max(answered_, exchange.t3);
  fit_.add(exchange);
  const ClockFit::Line line = fit_.at(answered_);
  const auto [low_ns, high_ns] = interval_.at(answered_);
  skew_ = line.skew;
  mapping_.steer(answered_, std::clamp(line.offset_ns, low_ns, high_ns), skew_);
  return true;
}

ServerTime ClockSync::toServer(ClientTime t) const {
  assert(known());
  return mapping_.toServer(t);
}

ClientTime ClockSync::toClient(ServerTime t) const {
  assert(known());
  return mapping_.toClient(t);
}

std::int64_t ClockSync::boundNs(ClientTime now) const {
  assert(known());
  const auto [low_ns, high_ns] = interval_.at(now);
  const std::int64_t offset_ns = offsetNs(now);
  return std::max(std::abs(offset_ns - low_ns), std::abs(high_ns - offset_ns));
}

}  // namespace coherency
