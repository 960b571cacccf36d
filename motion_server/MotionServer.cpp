#include "motion_server/MotionServer.h"

#include <chrono>
#include <cmath>
#include <thread>

#include <fmt/format.h>

#include "common/config/ConfigError.h"
#include "common/sync/StopSignal.h"
#include "motion_server/device/ReplayMaster.h"
#include "motion_server/device/SimulatedMaster.h"
#include "motion_server/device/simulated/OperatorTask.h"

namespace coherency {
namespace {

std::int64_t periodNs(const ServerConfig& config) {
  return std::llround(1e9 / config.rate_hz);
}

/// What the configuration names and cannot be had is the configuration's fault. `file`: what to name, where
/// the message does not.
auto orConfigError(const std::string& file, auto&& make) {
  try {
    return make();
  } catch (const std::exception& e) {
    throw ConfigError(file.empty() ? e.what() : file + ": " + e.what());
  }
}

std::unique_ptr<Scene> sceneOf(const ServerConfig& config) {
  return orConfigError(config.scene_file, [&] {
    auto scene = std::make_unique<Scene>(config.scene, config.rig);
    scene->initialState(config.world_seed);  // strewn, there must be room
    return scene;
  });
}

std::unique_ptr<Master> makeMaster(const ServerConfig& config, const Scene& scene) {
  if (config.master == "replay") {
    const ReplayOptions how{config.loop, config.seated ? HeadHeight::Seated : HeadHeight::Recorded};
    return orConfigError(
        "", [&] { return std::make_unique<ReplayMaster>(readRecording(config.recording), config.rig, how); });
  }
  for (const std::string& sentence : outOfReach(scene, scene.initialState(config.world_seed)))
    fmt::print(stderr, "motion_server: {}; the simulated operator will only look about\n", sentence);
  return std::make_unique<SimulatedMaster>(operatorTask(scene), config.rig, config.seed);
}

AuthorityConfig authorityConfig(const ServerConfig& config, const Scene& scene) {
  AuthorityConfig result;
  result.start = orConfigError(config.scene_file, [&] { return scene.initialState(config.world_seed); });
  result.start.mode = config.mode;
  result.dofs = scene.dofs();
  result.period_ns = periodNs(config);
  return result;
}

BroadcastConfig broadcastConfig(const ServerConfig& config) {
  BroadcastConfig result;
  result.address = config.address;
  result.port = config.port;
  result.redundancy = config.redundancy;
  result.max_clients = config.max_clients;
  return result;
}

SessionConfig sessionConfig(const ServerConfig& config) {
  SessionConfig result;
  result.scene = config.scene;
  result.rig = config.rig;
  result.period_ns = periodNs(config);
  return result;
}

constexpr double kMicrosecond = 1e3;  // ns

}  // namespace

MotionServer::MotionServer(const ServerOptions& options, const Clock& clock)
    : options_(options),
      clock_(clock),
      scene_(sceneOf(options.config)),
      master_(makeMaster(options.config, *scene_)),
      authority_(authorityConfig(options.config, *scene_), scene_->world(), *master_),
      broadcaster_(broadcastConfig(options.config), sessionConfig(options.config), clock) {}

void MotionServer::run(const std::function<void(const ServerStats&)>& onStatus) {
  catchStopSignals();
  sampling_ = std::make_unique<SamplingThread>(periodNs(options_.config),
                                               [this](const SamplingTick& tick) { return sample(tick); });
  const std::int64_t started_ns = clock_.nowNs();
  const auto due = [&] {
    const auto limit = options_.duration_s * 1e9;
    return limit > 0.0 && static_cast<double>(clock_.nowNs() - started_ns) >= limit;
  };
  std::int64_t last_status_ns = started_ns;
  while (sampling_->running() && !stopRequested() && !due()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (clock_.nowNs() - last_status_ns < 500'000'000) continue;
    last_status_ns = clock_.nowNs();
    onStatus(stats());
  }
  sampling_->stop();
  sampling_->join();
}

bool MotionServer::sample(const SamplingTick& tick) {
  if (const auto mode = broadcaster_.takeModeRequest()) authority_.switchTo(*mode);
  const auto result = authority_.sample(tick.elapsed_ns, tick.now_ns, tick.ticks_elapsed);
  if (!result) return false;
  broadcaster_.publish(result->world, result->sample);
  const std::scoped_lock lock(mutex_);
  ++samples_;
  mode_ = result->world.mode;
  task_ = result->world.task;
  elapsed_ns_ = tick.elapsed_ns;
  refused_ = authority_.refused();
  return true;
}

ServerStats MotionServer::stats() const {
  ServerStats stats;
  stats.master = master_->name();
  stats.scene = options_.config.scene.name;
  stats.nominal_rate_hz = 1e9 / static_cast<double>(periodNs(options_.config));
  stats.clients = broadcaster_.clients();
  stats.rejected = broadcaster_.rejected();
  stats.clients_served = broadcaster_.served();
  stats.stereo = broadcaster_.stereo();
  if (sampling_) {
    stats.missed = sampling_->jitter().missed.load();
    stats.period_jitter_us = spread(sampling_->jitter().deviation, kMicrosecond);
    stats.lateness_us = spread(sampling_->jitter().lateness, kMicrosecond);
    stats.real_time = sampling_->realTime();
  }
  const std::scoped_lock lock(mutex_);
  stats.samples = samples_;
  stats.mode = mode_;
  stats.task = task_;
  stats.duration_s = static_cast<double>(elapsed_ns_) / 1e9;
  stats.refused = refused_;
  return stats;
}

}  // namespace coherency
