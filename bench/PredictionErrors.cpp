#include "bench/PredictionErrors.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "common/math/FixedPoint.h"
#include "common/motion/DampedPredictor.h"
#include "common/motion/DofMotion.h"
#include "motion_server/device/ReplayMaster.h"

namespace coherency {

namespace {

constexpr double kDegrees = 360.0 / kTurn;
constexpr std::int64_t kEveryNs = 8'000'000;

/// The sample at a time, by the two about it; an independent way from PredictionScore's.
MotionSample sampleAt(const std::vector<MotionSample>& samples, std::int64_t time_ns) {
  const auto after =
      std::lower_bound(samples.begin() + 1, samples.end(), time_ns,
                       [](const MotionSample& s, std::int64_t t) { return s.server_time_ns < t; });
  const MotionSample& before = *(after - 1);
  const double share = static_cast<double>(time_ns - before.server_time_ns) /
                       static_cast<double>(after->server_time_ns - before.server_time_ns);
  MotionSample sample = before;
  for (std::size_t i = 0; i < kDofCount; ++i)
    sample.units[i] =
        moved(dofAt(i), before.units[i], share * displacement(dofAt(i), before.units[i], after->units[i]));
  return sample;
}

Coord3 headPosition(const MotionSample& s) {
  return {s.si(Dof::HeadX), s.si(Dof::HeadY), s.si(Dof::HeadZ)};
}

TransformMatrix headRotation(const MotionSample& s) {
  return rotation(YawPitchRoll{s.si(Dof::HeadYaw), s.si(Dof::HeadPitch), s.si(Dof::HeadRoll)});
}

double angleBetween(const TransformMatrix& a, const TransformMatrix& b) {
  double trace = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) trace += a(i, j) * b(i, j);
  return std::acos(std::clamp(0.5 * (trace - 1.0), -1.0, 1.0));
}

void compare(PredictionErrors& errors, const MotionSample& held, const MotionSample& predicted,
             const MotionSample& came) {
  const auto add = [&](ErrorGroup group, double off, double held_off) {
    errors.off[static_cast<std::size_t>(group)].push_back(off);
    if (off > held_off) ++errors.worse[static_cast<std::size_t>(group)];
  };
  add(ErrorGroup::HeadPosition, 1e3 * norm(headPosition(predicted) - headPosition(came)),
      1e3 * norm(headPosition(held) - headPosition(came)));
  add(ErrorGroup::HeadRotation, kDegrees * angleBetween(headRotation(predicted), headRotation(came)),
      kDegrees * angleBetween(headRotation(held), headRotation(came)));
  for (std::size_t j = 0; j < kArmJointCount; ++j) {
    const Dof dof = dofAt(index(Dof::ShoulderFlexion) + j);
    if (!held.isValid(dof)) continue;
    const auto off = [&](const MotionSample& s) {
      return kDegrees * kAngleUnit * std::abs(displacement(dof, s.units[index(dof)], came.units[index(dof)]));
    };
    add(ErrorGroup::ArmJoint, off(predicted), off(held));
  }
}

}  // namespace

std::vector<MotionSample> samplesOf(const Recording& recording, Sampled sampled) {
  ReplayMaster master(recording, Rig{}, {false, HeadHeight::Recorded});
  SampleGate gate({});
  std::vector<MotionSample> samples;
  const auto take = [&](std::int64_t time_ns) {
    if (const auto reading = master.read(time_ns, WorldState{}))
      samples.push_back(gate.admit(*reading, samples.size() + 1, time_ns));
  };
  if (sampled == Sampled::Rows)
    for (const RecordedRow& row : recording.rows) take(row.time_ns);
  else
    for (std::int64_t t = 0; t <= recording.durationNs(); t += 1'000'000) take(t);
  return samples;
}

void PredictionErrors::append(const PredictionErrors& other) {
  for (std::size_t g = 0; g < kErrorGroups; ++g) {
    off[g].insert(off[g].end(), other.off[g].begin(), other.off[g].end());
    worse[g] += other.worse[g];
  }
}

double PredictionErrors::quantile(ErrorGroup group, double q) const {
  std::vector<double> sorted = off[static_cast<std::size_t>(group)];
  if (sorted.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(sorted.size())));
  const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
  std::nth_element(sorted.begin(), nth, sorted.end());
  return *nth;
}

double PredictionErrors::worseShare(ErrorGroup group) const {
  const auto g = static_cast<std::size_t>(group);
  return off[g].empty() ? 0.0 : static_cast<double>(worse[g]) / static_cast<double>(off[g].size());
}

PredictionErrors predictionErrors(const std::vector<MotionSample>& samples, Prediction method, bool damped,
                                  double horizon_ms) {
  const PredictorConfig config{method, horizon_ms};
  const std::unique_ptr<Predictor> plain = makePredictor(config);
  DampedPredictor limited(config);
  const auto horizon_ns = std::llround(horizon_ms * 1e6);
  PredictionErrors errors;
  std::int64_t next_ns = 0;
  for (const MotionSample& sample : samples) {
    if (sample.server_time_ns + horizon_ns > samples.back().server_time_ns) break;
    plain->add(sample);
    limited.add(sample);
    if (sample.server_time_ns < next_ns) continue;
    next_ns = sample.server_time_ns + kEveryNs;
    const std::int64_t time_ns = sample.server_time_ns + horizon_ns;
    compare(errors, sample, damped ? limited.predictFor(time_ns) : plain->predict(horizon_ns),
            sampleAt(samples, time_ns));
  }
  return errors;
}

}  // namespace coherency
