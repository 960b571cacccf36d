#include "common/config/ServerConfig.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

#include "common/config/Endpoint.h"
#include "common/config/RigFile.h"
#include "common/config/SceneFile.h"
#include "common/config/Shipped.h"
#include "common/config/TomlTable.h"

namespace coherency {
namespace {

std::string besideFile(const std::string& file, const std::string& path) {
  return path.empty() ? path : (std::filesystem::path(file).parent_path() / path).lexically_normal().string();
}

/// Beside the file's folder; for a file somewhere else, what comes with the programs.
std::string scenesFolder(const std::string& file) {
  std::string beside = besideFile(file, "../scenes");
  std::error_code ignored;
  if (std::filesystem::is_directory(beside, ignored)) return beside;
  const std::string shipped = shippedFolder("scenes");
  return shipped.empty() ? beside : shipped;
}

void readMaster(TomlTable& root, const std::string& path, ServerConfig& config) {
  TomlTable master = root.table("master");
  config.master = master.oneOf("kind", config.master, {"simulated", "replay"});
  TomlTable simulated = master.table("simulated");
  config.seed =
      static_cast<std::uint64_t>(simulated.integer("seed", 1, 0, std::numeric_limits<std::int64_t>::max()));
  simulated.finish();
  TomlTable replay = master.table("replay");
  config.recording = besideFile(path, replay.text("recording", ""));
  config.loop = replay.flag("loop", config.loop);
  config.seated = replay.oneOf("head_height", "seated", {"seated", "recorded"}) == "seated";
  replay.finish();
  master.finish();
}

void readDelivery(TomlTable& network, ServerConfig& config) {
  config.encoding = network.oneOf("encoding", config.encoding, {"exact", "compact", "auto"});
  config.discovery = network.flag("discovery", config.discovery);
  const std::string group = network.text("multicast", "");
  if (group.empty()) return;
  const Endpoint endpoint = [&] {
    try {
      return parseEndpoint(group, 0);
    } catch (const ConfigError& e) {
      throw network.error("multicast", e.what());
    }
  }();
  if (endpoint.port == 0 || !isMulticast(endpoint.host))
    throw network.error(
        "multicast", fmt::format("\"{}\" is no group to send to; right would be an IPv4 group of one's own "
                                 "with a port, as \"239.255.74.30:7432\"",
                                 group));
  config.multicast_address = endpoint.host;
  config.multicast_port = endpoint.port;
}

void readFrames(TomlTable& root, ServerConfig& config) {
  TomlTable frames = root.table("frames");
  config.frames_hz = frames.number("hz", config.frames_hz, 1.0, 1000.0);
  config.least_margin_ms = frames.number("least_margin_ms", config.least_margin_ms, 0.0, 1000.0);
  config.most_margin_ms = frames.number("most_margin_ms", config.most_margin_ms, 0.0, 1000.0);
  if (config.most_margin_ms < config.least_margin_ms)
    throw frames.error("most_margin_ms", "is below least_margin_ms; right would be at least that");
  frames.finish();
  TomlTable prediction = root.table("prediction");
  config.prediction = prediction.oneOf("kind", config.prediction, {"none", "velocity", "kalman"});
  config.horizon_ms = prediction.number("horizon_ms", config.horizon_ms, 0.0, 200.0);
  prediction.finish();
  TomlTable accuracy = root.table("accuracy");
  config.hand_mm = accuracy.number("hand_mm", config.hand_mm, 0.0, 1000.0);
  config.view_px = accuracy.number("view_px", config.view_px, 0.0, 1000.0);
  accuracy.finish();
}

}  // namespace

void setScene(ServerConfig& config, const std::string& scene) {
  config.scene = readScene(scene, config.scenes_folder);
  config.scene_file = sceneFile(scene, config.scenes_folder);
}

ServerConfig readServerConfig(const std::string& path) {
  const toml::table parsed = parseTomlFile(path);
  TomlTable root(&parsed, path, "");
  ServerConfig config;
  config.scenes_folder = scenesFolder(path);
  const std::string scene = root.text("scene", "laboratory");
  const bool is_path = scene.ends_with(".toml");
  try {
    setScene(config, is_path ? besideFile(path, scene) : scene);
  } catch (const ConfigError& e) {
    throw root.error("scene", e.what());
  }
  config.mode =
      root.oneOf("mode", "operator", {"operator", "robot"}) == "robot" ? Mode::Robot : Mode::Operator;
  config.world_seed =
      static_cast<std::uint64_t>(root.integer("world_seed", 0, 0, std::numeric_limits<std::int64_t>::max()));
  const std::string rig = root.text("rig", "");
  if (!rig.empty()) config.rig = readRig(besideFile(path, rig), &config.rig_defaults);
  TomlTable network = root.table("network");
  const std::string address = network.text("address", config.address);
  const auto numeric = listenAddress(address);
  if (!numeric)
    throw network.error("address",
                        fmt::format("\"{}\" is no address of this machine to listen on; right would "
                                    "be \"127.0.0.1\", \"::1\" or, for all of this machine's, "
                                    "\"0.0.0.0\"",
                                    address));
  config.address = *numeric;
  config.port = static_cast<std::uint16_t>(network.integer("port", config.port, 0, 65535));
  config.redundancy = static_cast<int>(network.integer("redundancy", config.redundancy, 0, 7));
  config.max_clients = static_cast<int>(network.integer("max_clients", config.max_clients, 1, 1024));
  readDelivery(network, config);
  network.finish();
  readFrames(root, config);
  TomlTable sampling = root.table("sampling");
  config.rate_hz = sampling.number("rate_hz", config.rate_hz, 10.0, 10000.0);
  sampling.finish();
  readMaster(root, path, config);
  root.finish();
  return config;
}

}  // namespace coherency
