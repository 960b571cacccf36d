#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "common/sync/Clock.h"
#include "common/sync/FrameSchedule.h"
#include "common/world/Scene.h"
#include "motion_server/EncodingChoice.h"
#include "motion_server/Options.h"
#include "motion_server/StatsReport.h"
#include "motion_server/authority/Authority.h"
#include "motion_server/authority/Foresight.h"
#include "motion_server/broadcast/Announcer.h"
#include "motion_server/broadcast/Broadcaster.h"
#include "motion_server/device/Master.h"
#include "motion_server/sampling/SamplingThread.h"

namespace coherency {

/// A motion server as a whole: device -> sampling -> authority -> broadcast, once a sampling period.
class MotionServer {
 public:
  /// Opens the master and the ports. Throws ConfigError where the scene or the recording cannot be had, and
  /// std::runtime_error where a port cannot, with place and remedy.
  MotionServer(const ServerOptions& options, const Clock& clock);

  std::uint16_t port() const { return broadcaster_.port(); }
  /// Serves until Ctrl-C, the end of the duration or of the recording. `onStatus` is called twice a second.
  void run(const std::function<void(const ServerStats&)>& onStatus);
  ServerStats stats() const;
  /// Who was turned away since the last call and why, a line each.
  std::vector<std::string> takeRefusals() { return broadcaster_.takeRefusals(); }

 private:
  bool sample(const SamplingTick& tick);
  std::optional<FrameState> frameDue(const SamplingTick& tick, const WorldState& world);
  void announce();

  ServerOptions options_;
  const Clock& clock_;
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<Master> master_;
  EncodingChoice encoding_;
  Authority authority_;
  Foresight foresight_;
  FrameSchedule schedule_;
  Broadcaster broadcaster_;
  std::unique_ptr<Announcer> announcer_;
  mutable std::mutex mutex_;  ///< over what the sampling thread leaves for stats()
  std::uint64_t samples_ = 0;
  Mode mode_ = Mode::Operator;
  TaskClock task_;
  std::int64_t elapsed_ns_ = 0;
  std::array<std::uint64_t, kDofCount> refused_{};
  ScheduleStatus frames_;
  PredictionReport prediction_;
  std::size_t next_scored_ = 0;               ///< the DOF whose scores are read next
  std::unique_ptr<SamplingThread> sampling_;  ///< last, so that it ends before what it uses
};

}  // namespace coherency
