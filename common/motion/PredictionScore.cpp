#include "common/motion/PredictionScore.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "common/motion/DofMotion.h"

namespace coherency {

std::size_t horizonIndex(std::int64_t horizon_ns) {
  const double horizon_ms = static_cast<double>(horizon_ns) * 1e-6;
  const auto edge = std::lower_bound(kHorizonEdgesMs.begin(), kHorizonEdgesMs.end(), horizon_ms);
  return static_cast<std::size_t>(edge - kHorizonEdgesMs.begin());
}

void PredictionScore::predicted(const MotionSample& base, const MotionSample& raw, const MotionSample& given,
                                std::int64_t horizon_ns) {
  assert(horizon_ns >= 0);
  if (horizon_ns == 0) return;  // no prediction
  if (count_ == kPending || base.server_time_ns > std::numeric_limits<std::int64_t>::max() - horizon_ns) {
    ++unscored_;
    return;
  }
  pending_[count_++] = {base.server_time_ns + horizon_ns,
                        horizonIndex(horizon_ns),
                        base.valid,
                        base.units,
                        raw.units,
                        given.units};
}

void PredictionScore::arrived(const MotionSample& sample) {
  if (intervalSeconds(newest_, sample) == 0.0) {
    unscored_ += count_;
    count_ = 0;
  }
  for (std::size_t i = 0; i < count_;) {
    if (pending_[i].for_time_ns > sample.server_time_ns) {
      ++i;
      continue;
    }
    score(pending_[i], sample);
    pending_[i] = pending_[--count_];
  }
  newest_ = sample;
}

void PredictionScore::score(const Pending& p, const MotionSample& after) {
  const double share = static_cast<double>(p.for_time_ns - newest_.server_time_ns) /
                       static_cast<double>(after.server_time_ns - newest_.server_time_ns);
  const DofMask valid = p.valid & newest_.valid & after.valid;
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const Dof dof = dofAt(i);
    if ((valid & mask(dof)) == 0 || !movesOn(dof)) continue;
    const double came = displacement(dof, p.held[i], newest_.units[i]) +
                        share * displacement(dof, newest_.units[i], after.units[i]);
    add(records_[p.horizon][i], dof, p, came);
  }
}

void PredictionScore::add(Record& record, Dof dof, const Pending& p, double came) {
  const std::size_t i = index(dof);
  const double error = displacement(dof, p.held[i], p.given[i]) - came;
  record.error.add(error);
  record.held_error.add(came);
  if (std::abs(error) > std::abs(came)) ++record.worse;
  // In double, as times that restarted may be any distance apart.
  const double age_s = 1e-9 * (static_cast<double>(p.for_time_ns) - static_cast<double>(record.last_ns));
  const double kept = std::exp(-std::max(0.0, age_s) / kMemoryS);
  const double raw = displacement(dof, p.held[i], p.raw[i]);
  // Without it, where the head looks down, leaps of yaw and roll weighed as much as minutes of motion.
  const double weight = raw == 0.0 ? 0.0 : 1.0 / (std::abs(raw) + std::abs(came));
  record.raw_raw = kept * record.raw_raw + weight * raw * raw;
  record.raw_came = kept * record.raw_came + weight * raw * came;
  record.last_ns = p.for_time_ns;
}

double PredictionScore::gain(Dof dof, std::size_t horizon) const {
  const Record& record = records_[horizon][index(dof)];
  return record.raw_raw > 0.0 ? std::clamp(record.raw_came / record.raw_raw, 0.0, 1.0) : 1.0;
}

DofScore PredictionScore::report(Dof dof, std::size_t horizon) const {
  const Record& record = records_[horizon][index(dof)];
  const double unit = resolution(info(dof).kind);
  DofScore score;
  score.count = record.error.count();
  score.median = record.error.quantile(0.5) * unit;
  score.p95 = record.error.quantile(0.95) * unit;
  score.held_median = record.held_error.quantile(0.5) * unit;
  score.held_p95 = record.held_error.quantile(0.95) * unit;
  if (score.count > 0) score.worse = static_cast<double>(record.worse) / static_cast<double>(score.count);
  score.gain = gain(dof, horizon);
  return score;
}

}  // namespace coherency
