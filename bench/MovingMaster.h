#pragma once

#include <optional>

#include "common/wire/Packets.h"

namespace coherency {

/// A session's motion without a scene: every DOF moves, the base drives, and frames of 16 ms are to be seen
/// 20 ms later. What a broadcaster is fed with, where its own cost is what counts.
class MovingMaster {
 public:
  explicit MovingMaster(double rate_hz) : period_ns_(static_cast<std::int64_t>(1e9 / rate_hz)) {}

  /// The next sample, taken now.
  void sample(std::int64_t now_ns) {
    ++sample_.sequence;
    sample_.server_time_ns = now_ns;
    sample_.device_time_us = now_ns / 1000;
    sample_.valid = kAllDofs;
    for (std::size_t i = 0; i < kDofCount; ++i)
      sample_.units[i] = static_cast<std::int32_t>(sample_.sequence % 1000 * 100 + i);
    ++world_.tick;
    world_.master.base.x_nm += 1'000'000;
    const std::uint64_t number = world_.tick * static_cast<std::uint64_t>(period_ns_) / kFrameNs;
    const bool begins = number != frame_number_;
    frame_number_ = number;
    frame_ = begins ? std::optional(frame(now_ns)) : std::nullopt;
  }

  const WorldState& world() const { return world_; }
  const MotionSample& motion() const { return sample_; }
  const std::optional<FrameState>& newFrame() const { return frame_; }

 private:
  static constexpr std::uint64_t kFrameNs = 16'000'000;

  FrameState frame(std::int64_t now_ns) const {
    FrameState state{frame_number_, sample_, world_, 0};
    state.sample.server_time_ns = now_ns + 20'000'000;
    state.world.master.base.x_nm += 20'000'000;
    state.hash = stateHash(state.world, state.sample);
    return state;
  }

  std::int64_t period_ns_;
  MotionSample sample_;
  WorldState world_;
  std::uint64_t frame_number_ = 0;
  std::optional<FrameState> frame_;
};

}  // namespace coherency
