#include "common/sync/ClockInterval.h"

#include <cassert>
#include <cmath>
#include <cstdlib>

namespace coherency {

bool ClockInterval::tighten(const ClockExchange& exchange) {
  assert(exchange.possible());
  const Proof low{exchange.t3, exchange.t2.ns - exchange.t3.ns};
  const Proof high{exchange.t0, exchange.t1.ns - exchange.t0.ns};
  if (known() && (contradict(low, *high_) || contradict(*low_, high))) return false;
  // Compared where both have the same age.
  if (!low_ || static_cast<double>(low.offset_ns - low_->offset_ns) >= -drifted(low.at - low_->at))
    low_ = low;
  if (!high_ || static_cast<double>(high.offset_ns - high_->offset_ns) <= drifted(high.at - high_->at))
    high_ = high;
  return true;
}

ClockInterval::Bounds ClockInterval::at(ClientTime t) const {
  assert(known());
  return {low_->offset_ns - widening(*low_, t), high_->offset_ns + widening(*high_, t)};
}

bool ClockInterval::contradict(const Proof& low, const Proof& high) const {
  return low.offset_ns - high.offset_ns > widening(low, high.at);
}

std::int64_t ClockInterval::widening(const Proof& proof, ClientTime t) const {
  // 1 ns covers that clocks count in whole ones.
  return static_cast<std::int64_t>(std::ceil(drifted(std::abs(t - proof.at)))) + 1;
}

}  // namespace coherency
