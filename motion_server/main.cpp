#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "common/config/ConfigError.h"
#include "common/config/Endpoint.h"
#include "common/config/KeyFile.h"
#include "common/config/LiveFile.h"
#include "common/sync/Clock.h"
#include "common/world/Catalogue.h"
#include "motion_server/ClientNews.h"
#include "motion_server/MotionServer.h"
#include "motion_server/Options.h"
#include "motion_server/StatsReport.h"
#include "motion_server/device/UsbDevices.h"

namespace {

void listDevices() {
  const auto devices = coherency::listUsbDevices();
  if (devices.empty()) fmt::print(stderr, "no USB device is connected, or none may be seen by this user\n");
  for (const auto& device : devices) fmt::print("{}\n", coherency::describe(device));
}

void listObjects() {
  for (const auto& entry : coherency::catalogue())
    fmt::print("{:<18}{}{}{}\n", entry.kind, entry.what, entry.coloured ? "; takes a colour" : "",
               entry.counted ? "; needs a count" : "");
}

void serve(const coherency::ServerOptions& options) {
  using namespace coherency;
  const MonotonicClock clock;
  MotionServer server(options, clock);
  fmt::print(stderr, "listening on {}  scene {}, {} at {} Hz\n",
             describe(Endpoint{options.config.address, server.port()}), options.config.scene.name,
             server.stats().master, options.config.rate_hz);
  if (const auto& absent = options.config.rig_defaults; !absent.empty())
    fmt::print(stderr, "rig {} gives no {}: as in configs/rigs/default.toml\n", options.config.rig.name,
               fmt::join(absent, ", "));
  const bool terminal = isatty(STDERR_FILENO) != 0;
  LiveFile statistics(options.stats_json, statsJson(server.stats()));
  ClientNews news;
  server.run([&](const ServerStats& stats) {
    statistics.update(statsJson(stats));
    std::vector<std::string> lines = server.takeRefusals();
    for (std::string& line : news.since(stats.clients)) lines.push_back(std::move(line));
    for (const std::string& line : lines) fmt::print(stderr, "{}{}\n", terminal ? "\r\033[K" : "", line);
    if (terminal) fmt::print(stderr, "\r\033[K{}", statusLine(stats));
  });
  statistics.finish(statsJson(server.stats()));
  fmt::print(stderr, "{}{}\n", terminal ? "\r\033[K" : "", statusLine(server.stats()));
}

}  // namespace

int main(int argc, char** argv) {
  int exit_code = -1;
  const coherency::ServerOptions options = coherency::parseServerOptions(argc, argv, exit_code);
  if (exit_code >= 0) return exit_code;
  try {
    if (options.list_devices)
      listDevices();
    else if (!options.make_key.empty())
      coherency::makeKeyFile(options.make_key);
    else if (options.list_objects)
      listObjects();
    else
      serve(options);
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "motion_server: {}\n", e.what());
    return dynamic_cast<const coherency::ConfigError*>(&e) != nullptr ? 2 : 1;
  }
}
