#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace coherency {

/// Counts durations in bins whose width grows with the duration (64 to each power of two: quantiles
/// within 1.6 %). Constant memory, add() takes no lock and allocates nothing; one thread adds while others
/// read.
class DurationHistogram {
 public:
  void add(std::int64_t ns);  ///< negative counts as 0
  std::uint64_t count() const { return count_.load(std::memory_order_relaxed); }
  std::int64_t max() const { return max_.load(std::memory_order_relaxed); }
  /// Upper edge of the bin that holds the q-quantile (nearest rank), at most max(); 0 when nothing was added.
  std::int64_t quantile(double q) const;

 private:
  static constexpr std::size_t kSubBits = 6;
  static constexpr std::size_t kBins = (64 - kSubBits) << kSubBits;
  static std::size_t bin(std::uint64_t ns);
  static std::uint64_t upperEdge(std::size_t bin);

  std::array<std::atomic<std::uint64_t>, kBins> bins_{};
  std::atomic<std::uint64_t> count_{0};
  std::atomic<std::int64_t> max_{0};
};

/// What statistics tell of a duration, in the unit asked for.
struct Spread {
  double p50 = 0.0;
  double p99 = 0.0;
  double max = 0.0;
};
Spread spread(const DurationHistogram& durations, double unit_ns);

}  // namespace coherency
