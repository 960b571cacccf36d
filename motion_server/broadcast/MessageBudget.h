#pragma once

#include <cstdint>

#include "common/sync/Clock.h"

namespace coherency {

/// A token bucket: at most `rate` messages a second in the long run, and `burst` at once.
class MessageBudget {
 public:
  MessageBudget(std::int64_t rate, std::int64_t burst, ServerTime now);

  /// Whether one more is within the budget; if so it is taken from it.
  bool take(ServerTime now);

 private:
  std::int64_t interval_ns_;
  std::int64_t burst_ns_;
  ServerTime paid_until_;  ///< runs ahead of now by one interval a message taken
};

}  // namespace coherency
