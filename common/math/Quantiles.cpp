#include "common/math/Quantiles.h"

#include <algorithm>
#include <cmath>

namespace coherency {

Quantiles::Quantiles(std::size_t capacity) : newest_(capacity, 0.0) {}

void Quantiles::add(double value) {
  max_ = count_ == 0 ? value : std::max(max_, value);
  newest_[next_] = value;
  next_ = (next_ + 1) % newest_.size();
  ++count_;
}

double Quantiles::quantile(double q) const {
  const auto kept = static_cast<std::size_t>(std::min<std::uint64_t>(count_, newest_.size()));
  if (kept == 0) return 0.0;
  std::vector<double> sorted(newest_.begin(), newest_.begin() + static_cast<std::ptrdiff_t>(kept));
  const double rank = std::ceil(std::clamp(q, 0.0, 1.0) * static_cast<double>(kept));
  const auto nth = static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
  std::nth_element(sorted.begin(), sorted.begin() + nth, sorted.end());
  return sorted[static_cast<std::size_t>(nth)];
}

}  // namespace coherency
