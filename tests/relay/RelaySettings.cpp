#include "tests/relay/RelaySettings.h"

#include <cmath>
#include <sstream>

#include <CLI/CLI.hpp>

#include "common/config/CommandLine.h"

namespace coherency {
namespace {

constexpr double kHourMs = 3.6e6;

void declareMs(CLI::App& app, const std::string& name, std::int64_t& ns, const std::string& what) {
  app.add_option_function<double>(
         name, [&ns](double ms) { ns = std::llround(ms * 1e6); }, what)
      ->check(finite(0.0, kHourMs));
}

void declareProbability(CLI::App& app, const std::string& name, double& p, const std::string& what) {
  app.add_option(name, p, what)->check(finite(0.0, 1.0));
}

}  // namespace

void declareSettings(CLI::App& app, RelaySettings& settings) {
  ImpairmentSettings& udp = settings.udp;
  declareProbability(app, "--loss", udp.loss, "probability that a datagram is lost [0]");
  declareMs(app, "--burst-every-ms", udp.burst_every_ns,
            "mean time from the beginning of one burst of losses to the next [0: none]");
  declareMs(app, "--burst-ms", udp.burst_ns, "length of a burst, in which every datagram is lost [0]");
  app.add_flag("--burst-regular", udp.bursts_regular, "a burst every --burst-every-ms, not at random");
  declareMs(app, "--delay-ms", udp.delay_ns, "delay of datagrams [0]");
  declareMs(app, "--jitter-ms", udp.jitter_ns, "further delay by chance, from 0 to this [0]");
  app.add_flag("--reorder", udp.reorder, "let datagrams overtake each other by their jitter");
  declareProbability(app, "--duplicate", udp.duplicate, "probability that a datagram comes twice [0]");
  declareProbability(app, "--corrupt", udp.corrupt, "probability that one bit of a datagram is flipped [0]");
  app.add_flag("--block-udp", udp.block, "no datagram passes");
  declareMs(app, "--tcp-delay-ms", settings.tcp_delay_ns, "delay of TCP, in each direction [0]");
}

std::string changeSetting(const std::string& line, RelaySettings& settings) {
  std::istringstream words(line);
  std::string name, value, surplus;
  if (!(words >> name >> value) || words >> surplus || name.front() == '-')
    return "\"" + line + "\" is not NAME VALUE, as in: loss 0.1";
  CLI::App app;
  app.set_help_flag();
  RelaySettings changed = settings;
  declareSettings(app, changed);
  try {
    app.parse("--" + name + "=" + value);
  } catch (const CLI::ParseError& e) {
    return e.what();
  }
  if (std::string fault = faultOf(changed.udp); !fault.empty()) return fault;
  settings = changed;
  return {};
}

}  // namespace coherency
