#include "common/motion/VelocityPredictor.h"

#include <algorithm>

#include "common/motion/DofMotion.h"

namespace coherency {

void VelocityPredictor::observe(const MotionSample& sample, double interval_s) {
  count_ = interval_s > 0.0 ? std::min(count_ + 1, kEntries) : 1;
  last_ = (last_ + 1) % kEntries;
  ring_[last_] = {interval_s, sample.valid, sample.units};
}

double VelocityPredictor::travel(Dof dof, double horizon_s) const {
  double n = 0.0, t = 0.0, tt = 0.0, x = 0.0, tx = 0.0;  // sums over the window, from the newest sample
  double age = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const Entry& entry = before(i);
    // The half microsecond keeps a sample that jitters about the window's edge.
    if ((entry.valid & mask(dof)) == 0 || (i > 1 && age > kWindowS + 5e-7)) break;
    const double offset = displacement(dof, before(0).units[index(dof)], entry.units[index(dof)]);
    n += 1.0;
    t -= age;
    tt += age * age;
    x += offset;
    tx -= age * offset;
    age += entry.interval_s;
  }
  const double spread = n * tt - t * t;
  return spread > 0.0 ? (n * tx - t * x) / spread * horizon_s : 0.0;
}

}  // namespace coherency
