#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace coherency {

/// How far behind the highest counter a datagram may come: late ones, swapped by the network, pass once.
inline constexpr std::uint64_t kReplayWindow = 4096;

/// Which of a sender's counters were seen, of the newest kReplayWindow; older ones count as seen. Counters
/// begin at 1. The ring of bits is RFC 6479's, with one word more than the window has, so that it needs no
/// shifting and covers the window wherever in a word the highest counter lies.
class ReplayWindow {
 public:
  /// Neither taken before nor too old.
  bool fresh(std::uint64_t counter) const;
  /// Only what is fresh, and only what was authenticated: a counter far ahead makes all before it old.
  void take(std::uint64_t counter);

 private:
  static constexpr std::size_t kWords = kReplayWindow / 64 + 1;

  std::array<std::uint64_t, kWords> seen_{};
  std::uint64_t highest_ = 0;
};

}  // namespace coherency
