#include "common/sync/DurationHistogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace coherency {

/// Below 2^kSubBits a bin a nanosecond; above, the leading 1 gives the power and the next kSubBits bits the
/// bin.
std::size_t DurationHistogram::bin(std::uint64_t ns) {
  if (ns < (1U << kSubBits)) return static_cast<std::size_t>(ns);
  const auto shift = static_cast<std::size_t>(std::bit_width(ns)) - 1 - kSubBits;
  return (shift << kSubBits) + static_cast<std::size_t>(ns >> shift);
}

std::uint64_t DurationHistogram::upperEdge(std::size_t bin) {
  if (bin < (2U << kSubBits)) return bin;
  const std::size_t shift = (bin >> kSubBits) - 1;
  const std::uint64_t leading = (bin & ((1U << kSubBits) - 1)) + (1U << kSubBits);
  return ((leading + 1) << shift) - 1;
}

void DurationHistogram::add(std::int64_t ns) {
  const std::int64_t duration = std::max<std::int64_t>(0, ns);
  bins_[bin(static_cast<std::uint64_t>(duration))].fetch_add(1, std::memory_order_relaxed);
  if (duration > max()) max_.store(duration, std::memory_order_relaxed);
  count_.fetch_add(1, std::memory_order_relaxed);
}

std::int64_t DurationHistogram::quantile(double q) const {
  const std::uint64_t total = count();
  const double rank = std::ceil(std::clamp(q, 0.0, 1.0) * static_cast<double>(total));
  const auto wanted = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(rank));
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < kBins && total > 0; ++i) {
    seen += bins_[i].load(std::memory_order_relaxed);
    if (seen >= wanted) return std::min(max(), static_cast<std::int64_t>(upperEdge(i)));
  }
  return 0;
}

Spread spread(const DurationHistogram& durations, double unit_ns) {
  const auto in_unit = [&](std::int64_t ns) { return static_cast<double>(ns) / unit_ns; };
  return {in_unit(durations.quantile(0.5)), in_unit(durations.quantile(0.99)), in_unit(durations.max())};
}

}  // namespace coherency
