#include "render_client/compile/Grouping.h"

#include <algorithm>
#include <numeric>
#include <span>

#include <glm/common.hpp>

namespace coherency {
namespace {

double longest(const glm::dvec3& extent) {
  return std::max({extent.x, extent.y, extent.z});
}

class Grouping {
 public:
  Grouping(const std::vector<GroupItem>& items, std::size_t triangles, double size)
      : items_(items), triangles_(triangles), size_(size), numbers_(items.size()) {
    std::iota(numbers_.begin(), numbers_.end(), 0U);
    const auto alone = std::stable_partition(numbers_.begin(), numbers_.end(), [&](std::uint32_t i) {
      return longest(items_[i].high - items_[i].low) <= size_;
    });
    for (auto i = alone; i != numbers_.end(); ++i) groups_.push_back({*i});
    numbers_.erase(alone, numbers_.end());
    if (!numbers_.empty()) divide(numbers_);
  }
  std::vector<std::vector<std::uint32_t>> take() { return std::move(groups_); }

 private:
  void divide(std::span<std::uint32_t> numbers) {
    glm::dvec3 low(items_[numbers[0]].low);
    glm::dvec3 high(items_[numbers[0]].high);
    glm::dvec3 first(middle(numbers[0]));
    glm::dvec3 last(first);
    std::size_t triangles = 0;
    for (const std::uint32_t i : numbers) {
      low = glm::min(low, items_[i].low);
      high = glm::max(high, items_[i].high);
      first = glm::min(first, middle(i));
      last = glm::max(last, middle(i));
      triangles += items_[i].triangles;
    }
    if (numbers.size() == 1 || (triangles <= triangles_ && longest(high - low) <= size_)) {
      groups_.emplace_back(numbers.begin(), numbers.end());
      return;
    }
    const glm::dvec3 apart = last - first;
    const int axis = apart.x >= apart.y && apart.x >= apart.z ? 0 : apart.y >= apart.z ? 1 : 2;
    const std::size_t half = numbers.size() / 2;
    std::nth_element(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(half), numbers.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double at_a = middle(a)[axis];
                       const double at_b = middle(b)[axis];
                       return at_a != at_b ? at_a < at_b : a < b;
                     });
    divide(numbers.first(half));
    divide(numbers.subspan(half));
  }

  glm::dvec3 middle(std::uint32_t item) const { return 0.5 * (items_[item].low + items_[item].high); }

  const std::vector<GroupItem>& items_;
  const std::size_t triangles_;
  const double size_;
  std::vector<std::uint32_t> numbers_;
  std::vector<std::vector<std::uint32_t>> groups_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> group(const std::vector<GroupItem>& items, std::size_t triangles,
                                              double size) {
  return Grouping(items, triangles, size).take();
}

}  // namespace coherency
