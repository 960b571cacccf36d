#include "common/config/ServerConfig.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

#include "common/config/RigFile.h"
#include "common/config/TomlTable.h"
#include "common/world/Scene.h"

namespace coherency {
namespace {

std::string besideFile(const std::string& file, const std::string& path) {
  return path.empty() ? path : (std::filesystem::path(file).parent_path() / path).lexically_normal().string();
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

ServerConfig readServerConfig(const std::string& path) {
  const toml::table parsed = parseTomlFile(path);
  TomlTable root(&parsed, path, "");
  ServerConfig config;
  config.scene = root.text("scene", config.scene);
  const std::vector<std::string> scenes = sceneNames();
  if (std::find(scenes.begin(), scenes.end(), config.scene) == scenes.end())
    throw root.error("scene", fmt::format("\"{}\" is not known; must be one of: {}", config.scene,
                                          fmt::join(scenes, ", ")));
  const std::string rig = root.text("rig", "");
  if (!rig.empty()) config.rig = readRig(besideFile(path, rig));
  TomlTable network = root.table("network");
  config.address = network.text("address", config.address);
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
