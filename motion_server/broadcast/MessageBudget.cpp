#include "motion_server/broadcast/MessageBudget.h"

#include <algorithm>
#include <cassert>

namespace coherency {

MessageBudget::MessageBudget(std::int64_t rate, std::int64_t burst, ServerTime now)
    : interval_ns_(1'000'000'000 / rate), burst_ns_(interval_ns_ * burst), paid_until_(now) {
  assert(rate > 0 && burst > 0);
}

bool MessageBudget::take(ServerTime now) {
  const ServerTime paid_until = std::max(paid_until_, now) + interval_ns_;
  if (paid_until - now > burst_ns_) return false;
  paid_until_ = paid_until;
  return true;
}

}  // namespace coherency
