#include "motion_server/authority/Foresight.h"

#include <algorithm>
#include <cassert>

#include "common/motion/CompactCode.h"

namespace coherency {
namespace {

constexpr std::int64_t kFinestStepNs = 1'000'000;

}  // namespace

Foresight::Foresight(const ForesightConfig& config, const World& world)
    : config_(config), world_(world), predictor_(config.prediction) {}

void Foresight::add(const MotionSample& sample) {
  newest_ = sample;
  predictor_.add(sample);
}

/// In steps no finer than a millisecond: at ten samples in one the way ahead has to be paid for within one of
/// them.
void Foresight::stepOn(WorldState& world, const MotionSample& sample, std::int64_t ahead_ns) const {
  const std::int64_t step_ns = std::max(config_.period_ns, kFinestStepNs);
  const std::uint64_t then = world.tick + static_cast<std::uint64_t>(ahead_ns / config_.period_ns);
  for (std::int64_t at = step_ns; at <= ahead_ns; at += step_ns) world_.step(world, sample, step_ns);
  world.tick = then;
}

FrameState Foresight::frame(std::uint64_t number, const WorldState& world, ServerTime seen) {
  assert(newest_.sequence != 0);
  FrameState frame{number, newest_, world, 0};
  if (config_.prediction.method != Prediction::None) {
    const auto farthest_ns = static_cast<std::int64_t>(config_.prediction.max_horizon_ms * 1e6);
    const std::int64_t ahead_ns = std::clamp<std::int64_t>(seen.ns - newest_.server_time_ns, 0, farthest_ns);
    frame.sample = predictor_.predictFor(newest_.server_time_ns + ahead_ns);
    if (config_.compact) frame.sample = compacted(frame.sample);
    stepOn(frame.world, frame.sample, ahead_ns);
  }
  frame.sample.server_time_ns = seen.ns;
  frame.sample.device_time_us = 0;  // no device has said so
  frame.hash = stateHash(frame.world, frame.sample);
  return frame;
}

}  // namespace coherency
