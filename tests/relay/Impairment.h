#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <string>

namespace coherency {

/// What a network does to datagrams. The default does nothing. Probabilities are in [0, 1], each datagram's
/// own; times in ns.
struct ImpairmentSettings {
  double loss = 0.0;
  std::int64_t burst_every_ns = 0;  ///< mean from one burst's beginning to the next, at least 1 ms; 0: none
  std::int64_t burst_ns = 0;        ///< everything is lost for exactly so long; at most burst_every_ns
  bool bursts_regular = false;      ///< a burst every burst_every_ns; else what lies between is exponential
  std::int64_t delay_ns = 0;
  std::int64_t jitter_ns = 0;  ///< delay beyond delay_ns is uniform in [0, jitter_ns]
  bool reorder = false;        ///< each datagram has its own jitter; else none overtakes one before it
  double duplicate = 0.0;
  double corrupt = 0.0;  ///< one bit flipped, any with the same probability
  bool block = false;    ///< nothing passes
  bool operator==(const ImpairmentSettings&) const = default;
};

/// What is wrong with them, in words; empty when nothing is.
std::string faultOf(const ImpairmentSettings& settings);

/// What becomes of one datagram.
struct DatagramFate {
  enum class Drop { None, Loss, Burst, Blocked };
  Drop drop = Drop::None;
  int copies = 0;                           ///< 0 when dropped, 2 when duplicated
  std::array<std::int64_t, 2> leaves_ns{};  ///< when each copy is sent on; the first is the earlier one
  std::optional<std::size_t> flipped_bit;   ///< in [0, 8 bytes): bit n % 8 of byte n / 8, in all copies
  bool operator==(const DatagramFate&) const = default;
};

/// Which of a relay's streams of datagrams; each has chances of its own, all derived from one seed.
struct ImpairmentStream {
  std::uint64_t seed = 0;
  std::uint32_t flow = 0;
  std::uint32_t direction = 0;
};

/// One stream of datagrams through an impaired network: a function of stream, settings and arrival times
/// alone. The n-th datagram takes the n-th chances whatever the settings, so those lost at 5 % are lost at 10
/// % too. Bursts are intervals of time, which no rate of datagrams changes: of fixed length, with exponential
/// gaps between (an alternating renewal process; Cox, Renewal Theory, 1962), or regular with a phase by
/// chance.
class Impairment {
 public:
  /// Time begins at begin_ns with a gap between bursts. `settings` have no fault.
  Impairment(const ImpairmentStream& stream, const ImpairmentSettings& settings, std::int64_t begin_ns);

  /// Time never goes back from one call, or change(), to the next.
  DatagramFate pass(std::int64_t arrival_ns, std::size_t bytes);
  /// From now on. Bursts begin anew only if theirs have changed.
  void change(const ImpairmentSettings& settings, std::int64_t now_ns);

 private:
  bool inBurst(std::int64_t now_ns);
  void advanceBursts(std::int64_t now_ns);
  std::int64_t gap();

  ImpairmentSettings settings_;
  std::mt19937_64 chances_, burst_chances_;
  std::int64_t burst_begin_ns_ = 0;  // of the current or the next one
  std::int64_t newest_ns_;
  std::int64_t last_leaves_ns_;
};

}  // namespace coherency
