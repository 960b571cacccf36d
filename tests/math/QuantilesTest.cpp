#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/Quantiles.h"

namespace coherency {
namespace {

TEST(Quantiles, AreZeroBeforeTheFirstValue) {
  const Quantiles none(8);
  EXPECT_EQ(none.quantile(0.5), 0.0);
  EXPECT_EQ(none.count(), 0u);
}

RC_GTEST_PROP(Quantiles, AreTheNearestRanksOfTheNewestValues, ()) {
  const auto capacity = *rc::gen::inRange<std::size_t>(1, 50);
  const auto values = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000)));
  Quantiles quantiles(capacity);
  for (const int value : values) quantiles.add(value);
  RC_ASSERT(quantiles.count() == values.size());
  RC_ASSERT(quantiles.max() == *std::max_element(values.begin(), values.end()));

  const std::size_t kept = std::min(capacity, values.size());
  std::vector<int> newest(values.end() - static_cast<std::ptrdiff_t>(kept), values.end());
  std::sort(newest.begin(), newest.end());
  RC_ASSERT(quantiles.quantile(0.0) == newest.front());
  RC_ASSERT(quantiles.quantile(1.0) == newest.back());
  for (const double q : {0.25, 0.5, 0.99}) {
    const double value = quantiles.quantile(q);
    const auto below = std::count_if(newest.begin(), newest.end(), [&](int v) { return v < value; });
    const auto up_to = std::count_if(newest.begin(), newest.end(), [&](int v) { return v <= value; });
    RC_ASSERT(up_to > below);  // one of the values themselves
    RC_ASSERT(static_cast<double>(up_to) >= q * static_cast<double>(kept) - 1.0);
    RC_ASSERT(static_cast<double>(below) <= q * static_cast<double>(kept) + 1.0);
  }
}

}  // namespace
}  // namespace coherency
