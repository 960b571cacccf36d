#include <cstdio>
#include <exception>

#include <fmt/format.h>
#include <unistd.h>

#include "common/config/ConfigError.h"
#include "common/config/LiveFile.h"
#include "common/sync/Clock.h"
#include "motion_server/MotionServer.h"
#include "motion_server/Options.h"
#include "motion_server/StatsReport.h"
#include "motion_server/device/UsbDevices.h"

namespace {

void serve(const coherency::ServerOptions& options) {
  using namespace coherency;
  const MonotonicClock clock;
  MotionServer server(options, clock);
  const bool ipv6 = options.config.address.find(':') != std::string::npos;
  fmt::print(stderr, "listening on {}{}{}:{}  scene {}, {} at {} Hz\n", ipv6 ? "[" : "",
             options.config.address, ipv6 ? "]" : "", server.port(), options.config.scene.name,
             server.stats().master, options.config.rate_hz);
  const bool terminal = isatty(STDERR_FILENO) != 0;
  LiveFile statistics(options.stats_json, statsJson(server.stats()));
  server.run([&](const ServerStats& stats) {
    statistics.update(statsJson(stats));
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
    if (options.list_devices) {
      const auto devices = coherency::listUsbDevices();
      if (devices.empty())
        fmt::print(stderr, "no USB device is connected, or none may be seen by this user\n");
      for (const auto& device : devices) fmt::print("{}\n", coherency::describe(device));
      return 0;
    }
    serve(options);
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "motion_server: {}\n", e.what());
    return dynamic_cast<const coherency::ConfigError*>(&e) != nullptr ? 2 : 1;
  }
}
