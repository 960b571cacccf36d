#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "common/motion/MotionSample.h"

namespace coherency {

/// Keeps account of the sequence numbers of one session: which came by themselves, which only within a later
/// packet, which not at all. Remembers the newest kWindow numbers; what comes later than that stays counted
/// as lost.
class SequenceTracker {
 public:
  static constexpr std::size_t kWindow = 4096;

  enum class Arrival { Newest, Late, Again };

  struct Counts {
    std::uint64_t received = 0;   ///< packets, whether newest, late or again
    std::uint64_t lost = 0;       ///< numbers passed over that have not come by themselves until now
    std::uint64_t recovered = 0;  ///< of those, brought by another packet's previous samples
    std::uint64_t reordered = 0;  ///< packets that were late or came again
  };

  Arrival add(std::uint64_t sequence, std::span<const MotionSample> previous);
  /// The next packet is a first one again, whatever its number: what was not sent to us is not lost. Counts
  /// stay.
  void restart();

  const Counts& counts() const { return counts_; }

 private:
  enum class State : std::uint8_t { Came, Lost, Recovered };

  Arrival arrive(std::uint64_t sequence);
  void skipTo(std::uint64_t sequence);
  bool isRemembered(std::uint64_t sequence) const;
  State& state(std::uint64_t sequence) { return states_[sequence % kWindow]; }

  std::array<State, kWindow> states_{};
  std::uint64_t first_ = 0;  ///< 0: none yet
  std::uint64_t newest_ = 0;
  Counts counts_;
};

}  // namespace coherency
