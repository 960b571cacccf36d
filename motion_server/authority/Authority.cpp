#include "motion_server/authority/Authority.h"

#include <cassert>

#include "common/motion/CompactCode.h"

namespace coherency {

Authority::Authority(const AuthorityConfig& config, const World& world, Master& master)
    : config_(config),
      world_(world),
      master_(master),
      gate_(neutralPosture(world.model().master.rig)),
      state_(config.start) {
  assert(config.period_ns > 0);
}

std::optional<Authority::Result> Authority::sample(std::int64_t elapsed_ns, std::int64_t server_time_ns,
                                                   std::uint64_t ticks_elapsed) {
  std::optional<MasterReading> reading = master_.read(elapsed_ns, state_);
  if (!reading) return std::nullopt;
  reading->valid &= config_.dofs;
  MotionSample taken = gate_.admit(*reading, ++sequence_, server_time_ns);
  if (config_.compact) taken = compacted(taken);
  for (std::uint64_t i = 0; i < ticks_elapsed; ++i) world_.step(state_, taken, config_.period_ns);
  return Result{state_, taken};
}

std::array<std::int32_t, kDofCount> Authority::still() const {
  SampleGate gate(neutralPosture(world_.model().master.rig));
  const MotionSample sample = gate.admit({.valid = 0}, 1, 0);
  return config_.compact ? compacted(sample).units : sample.units;
}

bool Authority::switchTo(Mode mode) {
  if (!world_.has(mode)) return false;
  state_.mode = mode;
  return true;
}

}  // namespace coherency
