#include "render_client/receive/SequenceTracker.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace coherency {

SequenceTracker::Arrival SequenceTracker::add(std::uint64_t sequence,
                                              std::span<const MotionSample> previous) {
  assert(sequence > 0);
  const Arrival arrival = arrive(sequence);
  ++counts_.received;
  if (arrival != Arrival::Newest) ++counts_.reordered;
  for (const MotionSample& sample : previous) {
    if (!isRemembered(sample.sequence) || state(sample.sequence) != State::Lost) continue;
    state(sample.sequence) = State::Recovered;
    ++counts_.recovered;
  }
  return arrival;
}

SequenceTracker::Arrival SequenceTracker::arrive(std::uint64_t sequence) {
  if (first_ == 0) {
    first_ = newest_ = sequence;
    state(sequence) = State::Came;
    return Arrival::Newest;
  }
  if (sequence > newest_) {
    skipTo(sequence);
    return Arrival::Newest;
  }
  if (!isRemembered(sequence)) return Arrival::Late;
  const State was = std::exchange(state(sequence), State::Came);
  if (was == State::Came) return Arrival::Again;
  --counts_.lost;
  if (was == State::Recovered) --counts_.recovered;
  return Arrival::Late;
}

void SequenceTracker::skipTo(std::uint64_t sequence) {
  counts_.lost += sequence - newest_ - 1;
  // A gap wider than the window writes each place once.
  const std::uint64_t from = std::max(newest_ + 1, sequence > kWindow ? sequence - kWindow : 0);
  for (std::uint64_t s = from; s < sequence; ++s) state(s) = State::Lost;
  state(sequence) = State::Came;
  newest_ = sequence;
}

bool SequenceTracker::isRemembered(std::uint64_t sequence) const {
  return sequence >= first_ && sequence <= newest_ && newest_ - sequence < kWindow;
}

void SequenceTracker::restart() {
  first_ = newest_ = 0;
}

}  // namespace coherency
