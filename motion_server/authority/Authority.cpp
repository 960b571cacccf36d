#include "motion_server/authority/Authority.h"

#include <cassert>

namespace coherency {

Authority::Authority(const AuthorityConfig& config, const Rig& rig, Master& master)
    : config_(config), master_(master), gate_(neutralPosture(rig)) {
  assert(config.period_ns > 0);
  world_.base = config.start;
}

std::optional<Authority::Result> Authority::sample(std::int64_t elapsed_ns, std::int64_t server_time_ns,
                                                   std::uint64_t ticks_elapsed) {
  const std::optional<MasterReading> reading = master_.read(elapsed_ns, world_);
  if (!reading) return std::nullopt;
  const MotionSample taken = gate_.admit(*reading, ++sequence_, server_time_ns);
  for (std::uint64_t i = 0; i < ticks_elapsed; ++i)
    step(world_, taken, config_.period_ns, config_.limits, config_.area);
  return Result{world_, taken};
}

}  // namespace coherency
