#include "tests/relay/Options.h"

#include <cmath>
#include <limits>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "common/config/CommandLine.h"
#include "common/config/ConfigError.h"

namespace coherency {
namespace {

constexpr char kDescription[] =
    "Stands between clients and a server as a network with faults. TCP passes unchanged, UDP is impaired, in "
    "each\n"
    "direction and for each client by chances of its own. A server that tells its UDP port to its clients "
    "has to\n"
    "have the relay's port, at another address. Standard input takes lines while it runs, each answered by "
    "\"ok\" or\n"
    "by what is wrong: an option without dashes and its value, as \"loss 0.1\" or \"block-udp on\"; \"impair "
    "off\" and\n"
    "\"impair on\"; \"cut\", which ends all TCP connections; \"stats\", answered by the statistics on one "
    "line.";

Endpoint endpoint(const std::string& option, const std::string& text) {
  const Endpoint parsed = parseListenEndpoint(text, 0);
  if (parsed.port == 0)
    throw ConfigError(fmt::format("{} {}: give a port, as in 127.0.0.2:7430", option, text));
  return parsed;
}

}  // namespace

RelayOptions parseRelayOptions(int argc, char** argv, int& exit_code) {
  RelayOptions options;
  std::string listen, server;
  double flow_silence_s = 10.0;
  CLI::App app{kDescription};
  app.add_option("--listen", listen, "ADDR:PORT for clients, TCP and UDP")->required();
  app.add_option("--server", server, "ADDR:PORT of the server, TCP and UDP")->required();
  app.add_option("--seed", options.seed, "of all chances [0]")
      ->check(whole(0, std::numeric_limits<std::int64_t>::max()));
  declareSettings(app, options.settings);
  app.add_option("--flow-silence-s", flow_silence_s, "a client's UDP is forgotten after so much silence [10]")
      ->check(finite(0.1, 3600.0));
  app.add_flag("--until-stdin-closes", options.until_stdin_closes, "end when standard input does");
  app.add_option("--stats-json", options.stats_json, "write statistics to this file at the end");
  exit_code = parseArguments(app, argc, argv, "impairing_relay");
  if (exit_code >= 0) return options;
  try {
    options.listen = endpoint("--listen", listen);
    options.server = endpoint("--server", server);
    if (const std::string fault = faultOf(options.settings.udp); !fault.empty()) throw ConfigError(fault);
  } catch (const ConfigError& e) {
    fmt::print(stderr, "impairing_relay: {}\n", e.what());
    exit_code = 2;
  }
  options.flow_silence_ns = std::llround(flow_silence_s * 1e9);
  return options;
}

}  // namespace coherency
