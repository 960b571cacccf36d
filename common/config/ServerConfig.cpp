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
  network.finish();
  TomlTable sampling = root.table("sampling");
  config.rate_hz = sampling.number("rate_hz", config.rate_hz, 10.0, 10000.0);
  sampling.finish();
  readMaster(root, path, config);
  root.finish();
  return config;
}

}  // namespace coherency
