#include "common/wire/ReplayWindow.h"

#include <algorithm>
#include <cassert>

namespace coherency {
namespace {

std::uint64_t wordOf(std::uint64_t counter) {
  return counter / 64;
}
std::uint64_t bitOf(std::uint64_t counter) {
  return std::uint64_t{1} << counter % 64;
}

}  // namespace

bool ReplayWindow::fresh(std::uint64_t counter) const {
  if (counter == 0) return false;
  if (counter > highest_) return true;
  if (highest_ - counter >= kReplayWindow) return false;
  return (seen_[wordOf(counter) % kWords] & bitOf(counter)) == 0;
}

void ReplayWindow::take(std::uint64_t counter) {
  assert(fresh(counter));
  if (counter > highest_) {
    const std::uint64_t passed = std::min<std::uint64_t>(wordOf(counter) - wordOf(highest_), kWords);
    for (std::uint64_t i = 0; i < passed; ++i) seen_[(wordOf(counter) - i) % kWords] = 0;
    highest_ = counter;
  }
  seen_[wordOf(counter) % kWords] |= bitOf(counter);
}

}  // namespace coherency
