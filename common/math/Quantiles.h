#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coherency {

/// Quantiles of the newest `capacity` values of a stream, and the maximum of all of them. add() never
/// allocates.
class Quantiles {
 public:
  explicit Quantiles(std::size_t capacity = 16384);

  void add(double value);
  std::uint64_t count() const { return count_; }
  /// Nearest-rank quantile, q in 0..1, of the values kept; 0 when there are none.
  double quantile(double q) const;
  double max() const { return max_; }

 private:
  std::vector<double> newest_;
  std::size_t next_ = 0;
  std::uint64_t count_ = 0;
  double max_ = 0.0;
};

}  // namespace coherency
