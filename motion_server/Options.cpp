#include "motion_server/Options.h"

#include <limits>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "common/config/CommandLine.h"
#include "common/config/ConfigError.h"
#include "common/config/Endpoint.h"
#include "common/config/KeyFile.h"
#include "common/config/ReplaceFile.h"
#include "common/config/Shipped.h"

namespace coherency {
namespace {

void checkTogether(const ServerConfig& config, bool open) {
  if (config.master == "replay" && config.recording.empty())
    throw ConfigError("--master replay needs a recording: give --recording FILE or master.replay.recording");
  if (config.mode == Mode::Robot && !config.scene.robot)
    throw ConfigError(fmt::format(
        "mode robot: the scene {} has no robot; take another scene or mode operator", config.scene.name));
  if (!open && !isLoopback(config.address))
    throw ConfigError(
        fmt::format("listening on {} without a key would let anybody on the network join; make a key with "
                    "motion_server --make-key FILE, copy the file to each client and give --key FILE to all, "
                    "or add --insecure, or listen on 127.0.0.1",
                    config.address));
}

/// One that is there, whether the programs were installed or only built.
std::string firstConfig() {
  const std::string folder = shippedFolder("servers");
  return (folder.empty() ? "configs/servers" : folder) + "/laboratory.toml";
}

/// The command line's part that goes over the file's.
struct Overrides {
  std::string config_file, master, recording, scene, mode, listen, key_file;
  std::optional<std::uint64_t> world_seed;
  bool has_scene = false;
  bool insecure = false;
};

void declare(CLI::App& app, Overrides& over, ServerOptions& options) {
  app.add_option("--config", over.config_file,
                 fmt::format("server's TOML file; required. One to begin with: {}", firstConfig()));
  app.add_option("--master", over.master, "overrides master.kind: simulated or replay")
      ->check(CLI::IsMember({"simulated", "replay"}));
  app.add_option("--recording", over.recording, "CSV of recorded motion; implies --master replay");
  app.add_option("--scene", over.scene,
                 "overrides scene: a name of configs/scenes/, as corridor or grid:1000, or a TOML file");
  app.add_option("--mode", over.mode,
                 "overrides mode: operator or robot [operator]; F3 in a client's window switches")
      ->check(CLI::IsMember({"operator", "robot"}));
  app.add_option("--world-seed", over.world_seed,
                 "scatters what can be grasped anew [0: as the scene has it]")
      ->check(whole(0, std::numeric_limits<std::int64_t>::max()));
  app.add_option("--listen", over.listen,
                 "ADDR:PORT for TCP and UDP [127.0.0.1:7430]; port 0 takes a free one");
  app.add_option("--key", over.key_file,
                 "file with the key that clients must have (--make-key makes one); they and nobody else can "
                 "join, listen or speak");
  app.add_flag("--insecure", over.insecure,
               "without a key, allow addresses other than loopback: anybody there can join");
  app.add_option("--make-key", options.make_key, "make a key, write it to this new file and end");
  app.add_option("--duration", options.duration_s, "end after this many seconds [0: until Ctrl-C]")
      ->check(finite(0.0, 1e9));
  app.add_option("--stats-json", options.stats_json, "write statistics to this file, anew twice a second");
  app.add_flag("--list-devices", options.list_devices, "list USB devices and end");
  app.add_flag("--list-objects", options.list_objects,
               "list the kinds of objects that scenes can name and end");
  app.set_version_flag("--version", COHERENCY_VERSION);
}

ServerConfig configured(const Overrides& over) {
  if (over.config_file.empty())
    throw ConfigError("--config FILE is missing; a good one to begin with is " + firstConfig());
  ServerConfig config = readServerConfig(over.config_file);
  if (over.has_scene) setScene(config, over.scene);
  if (!over.mode.empty()) config.mode = over.mode == "robot" ? Mode::Robot : Mode::Operator;
  if (over.world_seed) config.world_seed = *over.world_seed;
  if (!over.recording.empty()) config.recording = over.recording, config.master = "replay";
  if (!over.master.empty()) config.master = over.master;
  if (!over.listen.empty()) {
    const Endpoint endpoint = parseListenEndpoint(over.listen, config.port);
    config.address = endpoint.host;
    config.port = endpoint.port;
  }
  checkTogether(config, over.insecure || !over.key_file.empty());
  return config;
}

}  // namespace

ServerOptions parseServerOptions(int argc, char** argv, int& exit_code) {
  ServerOptions options;
  Overrides over;
  CLI::App app{"Reads a 19-DOF master, steps the shared world and broadcasts both to render clients."};
  try {
    declare(app, over, options);
    exit_code = parseArguments(app, argc, argv, "motion_server");
    if (exit_code >= 0 || options.list_devices || options.list_objects || !options.make_key.empty())
      return options;
    over.has_scene = app.count("--scene") > 0;
    options.config = configured(over);
    if (!over.key_file.empty()) options.key = readKeyFile(over.key_file);
    checkReplaceable("--stats-json", options.stats_json);
  } catch (const ConfigError& e) {
    fmt::print(stderr, "motion_server: {}\n", e.what());
    exit_code = 2;
  }
  return options;
}

}  // namespace coherency
