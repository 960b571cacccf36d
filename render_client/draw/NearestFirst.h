#pragma once

#include <algorithm>
#include <vector>

namespace coherency {

/// Things in the order in which they are drawn: nearest first, so that what they hide is not shaded.
class NearestFirst {
 public:
  struct Shown {
    std::size_t number;  ///< as whoever added it counts
    double distance;     ///< m, of its box's farthest corner from the eye
  };

  explicit NearestFirst(std::size_t capacity) { shown_.reserve(capacity); }
  void clear() { shown_.clear(); }
  void add(std::size_t number, double distance) { shown_.push_back({number, distance}); }
  void sort() {
    std::sort(shown_.begin(), shown_.end(), [](const Shown& a, const Shown& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.number < b.number;
    });
  }
  const std::vector<Shown>& shown() const { return shown_; }

 private:
  std::vector<Shown> shown_;
};

}  // namespace coherency
