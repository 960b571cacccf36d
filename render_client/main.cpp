#include <cstdio>
#include <exception>

#include <fmt/format.h>
#include <unistd.h>

#include "common/config/LiveFile.h"
#include "common/sync/Clock.h"
#include "render_client/LinkNews.h"
#include "render_client/Options.h"
#include "render_client/RenderClient.h"
#include "render_client/StatsReport.h"
#include "render_client/receive/ServerSearch.h"

namespace {

constexpr std::int64_t kSearchNs = 1'000'000'000;

int listServers() {
  const auto servers = coherency::searchServers(kSearchNs);
  for (const auto& server : servers) fmt::print("{}\n", coherency::describe(server));
  if (!servers.empty()) return 0;
  fmt::print(
      stderr,
      "no server answers on this network: start motion_server, on an address that this machine reaches and "
      "with UDP port {} open\n",
      coherency::kDiscoveryPort);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace coherency;
  int exit_code = -1;
  const ClientOptions options = parseClientOptions(argc, argv, exit_code);
  if (exit_code >= 0) return exit_code;
  try {
    if (options.discover) return listServers();
    const MonotonicClock clock;
    const std::string server = describe(options.server);
    fmt::print(stderr, "{} eye{}: asking the server at {}, for {} s at most\n", options.eye,
               options.eye == "both" ? "s" : "", server, options.wait_s);
    RenderClient client(options, clock);
    const ClientStats begun = client.stats();
    fmt::print(stderr, "drawing {} with {}\n", begun.scene, begun.renderer);
    if (options.explain) fmt::print("{}", client.explain());
    const bool terminal = isatty(STDERR_FILENO) != 0;
    LiveFile statistics(options.stats_json, statsJson(begun));
    LinkNews news(server);
    std::size_t warned = 0;
    client.run([&](const ClientStats& stats) {
      statistics.update(statsJson(stats));
      const char* const clear = terminal ? "\r\033[K" : "";
      if (const auto line = news.since(stats.link)) fmt::print(stderr, "{}{}\n", clear, *line);
      for (; warned < stats.found_to_move.size(); ++warned)
        fmt::print(stderr, "{}'{}' moved, so the scene had to be compiled again; declare it Moving\n", clear,
                   stats.found_to_move[warned]);
      if (terminal) fmt::print(stderr, "\r\033[K{}", statusLine(stats));
    });
    statistics.finish(statsJson(client.stats()));
    fmt::print(stderr, "{}{}\n", terminal ? "\r\033[K" : "", statusLine(client.stats()));
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "render_client: {}\n", e.what());
    return 1;
  }
}
