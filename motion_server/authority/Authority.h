#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "common/motion/SampleGate.h"
#include "common/world/World.h"
#include "motion_server/device/Master.h"

namespace coherency {

/// A session's beginning.
struct AuthorityConfig {
  WorldState start;
  DofMask dofs =
      kAllDofs;  ///< that the scene needs; the others keep to the neutral posture and are never valid
  std::int64_t period_ns = 1'000'000;
  bool compact = false;  ///< samples are such as the compact encoding can tell (CompactCode.h)
};

/// The one place where a session's state changes (design, "The shared world"): reads the master, lets its
/// reading through the gate, and steps the world.
class Authority {
 public:
  /// `world` and `master` outlive this.
  Authority(const AuthorityConfig& config, const World& world, Master& master);

  struct Result {
    WorldState world;
    MotionSample sample;
  };
  /// One sample at `elapsed_ns` since the session began, `server_time_ns` on the server's clock. The world is
  /// stepped `ticks_elapsed` periods, so that after missed ones its tick still is elapsed time over period.
  /// nullopt: the master has ended, and nothing has changed.
  std::optional<Result> sample(std::int64_t elapsed_ns, std::int64_t server_time_ns,
                               std::uint64_t ticks_elapsed);

  /// From the next sample on. A mode the world does not have is passed over: false.
  bool switchTo(Mode mode);

  /// Where the DOFs stand that nothing was measured of yet, or that the scene does not need.
  std::array<std::int32_t, kDofCount> still() const;

  const WorldState& state() const { return state_; }
  const std::array<std::uint64_t, kDofCount>& refused() const { return gate_.refused(); }

 private:
  AuthorityConfig config_;
  const World& world_;
  Master& master_;
  SampleGate gate_;
  WorldState state_;
  std::uint64_t sequence_ = 0;
};

}  // namespace coherency
