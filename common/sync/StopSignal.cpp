#include "common/sync/StopSignal.h"

#include <atomic>
#include <csignal>

namespace coherency {
namespace {

std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

void onSignal(int signal) {
  requested.store(true);
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catchStopSignals() {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

bool stopRequested() {
  return requested.load();
}

}  // namespace coherency
