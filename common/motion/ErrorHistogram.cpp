#include "common/motion/ErrorHistogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace coherency {

void ErrorHistogram::add(double error) {
  const auto size = static_cast<std::uint64_t>(std::llround(std::min(std::abs(error), 4294967295.0)));
  std::size_t bin = static_cast<std::size_t>(size);
  if (size >= (1U << kSubBits)) {
    // The leading 1 gives the power, the next kSubBits bits the bin.
    const auto shift = static_cast<std::size_t>(std::bit_width(size)) - 1 - kSubBits;
    bin = (shift << kSubBits) + static_cast<std::size_t>(size >> shift);
  }
  ++bins_[bin];
  ++count_;
}

double ErrorHistogram::quantile(double q) const {
  const double rank = std::ceil(std::clamp(q, 0.0, 1.0) * static_cast<double>(count_));
  const auto wanted = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(rank));
  std::uint64_t seen = 0;
  for (std::size_t bin = 0; bin < kBins && count_ > 0; ++bin) {
    seen += bins_[bin];
    if (seen < wanted) continue;
    if (bin < (2U << kSubBits)) return static_cast<double>(bin);
    const std::size_t shift = (bin >> kSubBits) - 1;
    const std::uint64_t leading = (bin & ((1U << kSubBits) - 1)) + (1U << kSubBits);
    return static_cast<double>(((leading + 1) << shift) - 1);
  }
  return 0.0;
}

}  // namespace coherency
