#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace coherency {

/// Counts sizes of errors in integer units, 16 bins to each power of two: quantiles within 6.3 %. Constant
/// memory, one thread.
class ErrorHistogram {
 public:
  void add(double error);  ///< its size to the nearest unit; beyond 2^32 - 1 it counts as that. Not NaN.
  std::uint64_t count() const { return count_; }
  /// Upper edge of the bin that holds the q-quantile (nearest rank); 0 when nothing was added.
  double quantile(double q) const;

 private:
  static constexpr std::size_t kSubBits = 4;
  static constexpr std::size_t kBins = (33 - kSubBits) << kSubBits;

  std::array<std::uint32_t, kBins> bins_{};
  std::uint64_t count_ = 0;
};

}  // namespace coherency
