#include "motion_server/Options.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "common/config/ConfigError.h"
#include "common/config/Endpoint.h"
#include "common/config/FiniteNumber.h"
#include "common/config/SceneFile.h"

namespace coherency {
namespace {

bool isLoopback(const std::string& address) {
  return address == "::1" || address.starts_with("127.");
}

void checkTogether(const ServerConfig& config, bool insecure) {
  if (config.master == "replay" && config.recording.empty())
    throw ConfigError("--master replay needs a recording: give --recording FILE or master.replay.recording");
  if (config.mode == Mode::Robot && !config.scene.robot)
    throw ConfigError(fmt::format(
        "mode robot: the scene {} has no robot; take another scene or mode operator", config.scene.name));
  if (!insecure && !isLoopback(config.address))
    throw ConfigError(
        fmt::format("listening on {} would send unencrypted motion over the network; "
                    "add --insecure to do so, or listen on 127.0.0.1",
                    config.address));
}

}  // namespace

ServerOptions parseServerOptions(int argc, char** argv, int& exit_code) {
  ServerOptions options;
  std::string config_file, master, recording, listen, scene, mode;
  std::optional<std::uint64_t> world_seed;
  bool insecure = false;
  CLI::App app{"Reads a 19-DOF master, steps the shared world and broadcasts both to render clients."};
  app.add_option("--config", config_file, "server's TOML file (see share/coherency/servers/); required");
  app.add_option("--master", master, "overrides master.kind: simulated or replay")
      ->check(CLI::IsMember({"simulated", "replay"}));
  app.add_option("--recording", recording, "CSV of recorded motion; implies --master replay");
  app.add_option("--scene", scene,
                 "overrides scene: a name of configs/scenes/, as corridor or grid:1000, or a TOML file");
  app.add_option("--mode", mode,
                 "overrides mode: operator or robot [operator]; F3 in a client's window switches")
      ->check(CLI::IsMember({"operator", "robot"}));
  app.add_option("--world-seed", world_seed, "scatters what can be grasped anew [0: as the scene has it]");
  app.add_option("--listen", listen, "ADDR:PORT for TCP and UDP [127.0.0.1:7430]; port 0 takes a free one");
  app.add_flag("--insecure", insecure,
               "allow addresses other than loopback although the link is not encrypted");
  app.add_option("--duration", options.duration_s, "end after this many seconds [0: until Ctrl-C]")
      ->check(finite(0.0, 1e9));
  app.add_option("--stats-json", options.stats_json, "write statistics to this file, anew twice a second");
  app.add_flag("--list-devices", options.list_devices, "list USB devices and end");
  app.set_version_flag("--version", COHERENCY_VERSION);
  try {
    app.parse(argc, argv);
    if (options.list_devices) return options;
    if (config_file.empty())
      throw ConfigError(
          "--config FILE is missing; a good one to begin with is configs/servers/laboratory.toml");
    options.config = readServerConfig(config_file);
    if (!scene.empty()) options.config.scene = readScene(scene, options.config.scenes_folder);
    if (!mode.empty()) options.config.mode = mode == "robot" ? Mode::Robot : Mode::Operator;
    if (world_seed) options.config.world_seed = *world_seed;
    if (!recording.empty()) options.config.recording = recording, options.config.master = "replay";
    if (!master.empty()) options.config.master = master;
    if (!listen.empty()) {
      const Endpoint endpoint = parseEndpoint(listen, options.config.port);
      options.config.address = endpoint.host == "localhost" ? "127.0.0.1" : endpoint.host;
      options.config.port = endpoint.port;
    }
    checkTogether(options.config, insecure);
  } catch (const CLI::ParseError& e) {
    exit_code = app.exit(e) == 0 ? 0 : 2;
  } catch (const ConfigError& e) {
    fmt::print(stderr, "motion_server: {}\n", e.what());
    exit_code = 2;
  }
  return options;
}

}  // namespace coherency
