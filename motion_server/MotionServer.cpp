#include "motion_server/MotionServer.h"

#include <array>
#include <chrono>
#include <cmath>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "common/config/ConfigError.h"
#include "common/sync/StopSignal.h"
#include "common/world/Names.h"
#include "motion_server/device/ReplayMaster.h"
#include "motion_server/device/SimulatedMaster.h"
#include "motion_server/device/simulated/OperatorTask.h"

namespace coherency {
namespace {

constexpr double kMicrosecond = 1e3;  // ns
constexpr double kMillisecond = 1e6;
constexpr std::size_t kReportsHeeded = 256;  // a frame

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

AuthorityConfig authorityConfig(const ServerConfig& config, const Scene& scene, bool compact) {
  AuthorityConfig result;
  result.start = orConfigError(config.scene_file, [&] { return scene.initialState(config.world_seed); });
  result.start.mode = config.mode;
  result.dofs = scene.dofs();
  result.period_ns = periodNs(config);
  result.compact = compact;
  return result;
}

BroadcastConfig broadcastConfig(const ServerOptions& options) {
  const ServerConfig& config = options.config;
  BroadcastConfig result;
  result.address = config.address;
  result.port = config.port;
  result.redundancy = config.redundancy;
  result.max_clients = config.max_clients;
  result.key = options.key;
  return result;
}

ForesightConfig foresightConfig(const ServerConfig& config, bool compact) {
  ForesightConfig result;
  result.prediction.method = *predictionByName(config.prediction);  // the configuration knows no others
  result.prediction.max_horizon_ms = config.horizon_ms;
  result.period_ns = periodNs(config);
  result.compact = compact;
  return result;
}

FrameScheduleConfig scheduleConfig(const ServerConfig& config) {
  return {std::llround(1e9 / config.frames_hz), std::llround(config.least_margin_ms * kMillisecond),
          std::llround(config.most_margin_ms * kMillisecond)};
}

SessionConfig sessionConfig(const ServerConfig& config, const Scene& scene, const Authority& authority,
                            bool compact) {
  SessionConfig result;
  result.scene = config.scene;
  result.rig = config.rig;
  result.period_ns = periodNs(config);
  result.frame_ns = scheduleConfig(config).frame_ns;
  result.form = {scene.dofs(), compact, authority.still()};
  if (!config.multicast_address.empty()) result.multicast = {config.multicast_address, config.multicast_port};
  return result;
}

std::string hostName() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "";
  return isPlainText(name.data()) ? name.data() : "";
}

}  // namespace

MotionServer::MotionServer(const ServerOptions& options, const Clock& clock)
    : options_(options),
      clock_(clock),
      scene_(sceneOf(options.config)),
      master_(makeMaster(options.config, *scene_)),
      encoding_(chooseEncoding(options.config)),
      authority_(authorityConfig(options.config, *scene_, encoding_.compact), scene_->world(), *master_),
      foresight_(foresightConfig(options.config, encoding_.compact), scene_->world()),
      schedule_(scheduleConfig(options.config)),
      broadcaster_(broadcastConfig(options),
                   sessionConfig(options.config, *scene_, authority_, encoding_.compact), clock) {
  if (options.config.discovery) announce();
}

/// A convenience: a server nobody can find by searching serves all the same.
void MotionServer::announce() {
  try {
    announcer_ = std::make_unique<Announcer>(options_.config.address, [this, host = hostName()] {
      return Announcement{kWireMajor,
                          kWireMinor,
                          host,
                          options_.config.scene.name,
                          broadcaster_.port(),
                          options_.key != kNoKey,
                          static_cast<std::uint32_t>(broadcaster_.present())};
    });
  } catch (const std::runtime_error& e) {
    fmt::print(stderr, "motion_server: {}; render_client --discover will not find this server\n", e.what());
  }
}

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
  foresight_.add(result->sample);
  const auto frame = frameDue(tick, result->world);
  broadcaster_.publish(result->world, result->sample, frame);
  const std::scoped_lock lock(mutex_);
  ++samples_;
  mode_ = result->world.mode;
  task_ = result->world.task;
  elapsed_ns_ = tick.elapsed_ns;
  refused_ = authority_.refused();
  if (frame) {
    const double drawn_hz =
        1e9 / static_cast<double>(schedule_.frameNs()) / static_cast<double>(schedule_.stride());
    frames_ = {drawn_hz, static_cast<double>(schedule_.marginNs()) / kMillisecond, schedule_.stride()};
    // One DOF a frame: to read all scores at once takes longer than a period at 10 kHz.
    for (std::size_t h = 0; h < kHorizons; ++h)
      prediction_[next_scored_][h] = foresight_.score().report(dofAt(next_scored_), h);
    next_scored_ = (next_scored_ + 1) % kDofCount;
  }
  return true;
}

std::optional<FrameState> MotionServer::frameDue(const SamplingTick& tick, const WorldState& world) {
  const auto due = schedule_.take(tick.elapsed_ns);
  if (!due) return std::nullopt;
  const std::int64_t session_start_ns = tick.due_ns - tick.elapsed_ns;
  std::vector<FrameReport> reports = broadcaster_.takeReports();
  if (reports.size() > kReportsHeeded)
    reports.resize(kReportsHeeded);  // more than honest eyes have in a frame
  for (const FrameReport& report : reports) {
    if (report.arrived_server_ns == 0 || report.number >= due->number) continue;  // or was never there
    const std::int64_t moment_ns =
        session_start_ns + static_cast<std::int64_t>(report.number) * schedule_.frameNs();
    schedule_.heard({report.arrived_server_ns - moment_ns, report.draw_ns,
                     static_cast<std::int64_t>(report.number) * schedule_.frameNs()});
  }
  return foresight_.frame(due->number, world, {session_start_ns + due->moment_ns + due->margin_ns});
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
  stats.encoding = encoding_.reason;
  stats.frames = frames_;
  stats.prediction = options_.config.prediction;
  stats.predicted = prediction_;
  return stats;
}

}  // namespace coherency
