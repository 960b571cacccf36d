#include "common/sync/ClockOffset.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace coherency {

bool ClockOffset::add(const ClockExchange& exchange) {
  const std::int64_t there_and_back = exchange.t3 - exchange.t0;
  const std::int64_t at_server = exchange.t2 - exchange.t1;
  if (there_and_back < 0 || at_server < 0 || there_and_back < at_server) return false;
  const std::int64_t twice_offset = (exchange.t1.ns - exchange.t0.ns) + (exchange.t2.ns - exchange.t3.ns);
  const Estimate fresh{exchange.t0, there_and_back - at_server, twice_offset / 2};
  if (!best_) {
    best_ = fresh;
    return true;
  }
  const ClientTime now = std::max(exchange.t3, best_->asked);
  const std::int64_t fresh_bound = boundNs(fresh, now);
  const std::int64_t best_bound = boundNs(*best_, now);
  const bool contradiction = std::abs(fresh.offset_ns - best_->offset_ns) > fresh_bound + best_bound;
  if (fresh_bound <= best_bound || contradiction) best_ = fresh;
  return true;
}

std::int64_t ClockOffset::offsetNs() const {
  assert(known());
  return best_->offset_ns;
}

std::int64_t ClockOffset::boundNs(ClientTime now) const {
  assert(known());
  return boundNs(*best_, now);
}

std::int64_t ClockOffset::boundNs(const Estimate& estimate, ClientTime now) const {
  // Drift counts from the asking, not from the answer: the clocks drift during the exchange too. 2 ns cover
  // what the two halvings round away.
  const auto age = static_cast<double>(std::max<std::int64_t>(0, now - estimate.asked));
  return estimate.round_trip_ns / 2 + static_cast<std::int64_t>(std::ceil(age * drift_)) + 2;
}

}  // namespace coherency
