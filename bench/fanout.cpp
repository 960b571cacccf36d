// What the server's process costs as clients grow, and whether all of them get everything: a broadcaster
// here, all clients in a second process, loopback. Prints a line for each number of clients.
#include <array>
#include <cstdio>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/MovingMaster.h"
#include "common/sync/Clock.h"
#include "motion_server/broadcast/Broadcaster.h"
#include "motion_server/sampling/SamplingThread.h"
#include "render_client/receive/ServerLink.h"

namespace {

using namespace coherency;

struct Settings {
  double rate_hz = 1000.0;
  double seconds = 4.0;
  bool multicast = false;
};

/// What a number of clients got of a run; from their process to the server's.
struct Received {
  std::uint64_t packets = 0;
  std::uint64_t lost = 0;
  std::uint64_t by_multicast = 0;  ///< clients
};

constexpr std::int64_t kPatienceNs = 150'000'000;  // less than a client's with a silent group

/// The clients' process. All have joined before it says so, and count from there.
void receive(std::uint16_t port, int clients, int report) {
  const MonotonicClock clock;
  std::vector<std::unique_ptr<ServerLink>> links;
  for (int i = 0; i < clients; ++i)
    links.push_back(std::make_unique<ServerLink>(LinkConfig{"127.0.0.1", port, "mono"}, clock));
  for (auto& link : links) link->waitForSession(5'000'000'000);
  for (auto& link : links) link->waitForTick(1, 5'000'000'000);
  std::uint64_t tick = 0;
  while (links.front()->waitForTick(tick + 1, kPatienceNs)) tick = links.front()->newest()->packet.world.tick;
  Received all;
  for (auto& link : links) {
    const LinkStats stats = link->stats();
    all.packets += stats.received;
    all.lost += stats.lost;
    all.by_multicast += stats.way == MotionWay::Multicast ? 1 : 0;
  }
  if (write(report, &all, sizeof all) != sizeof all) std::perror("bench_fanout: write");
}

double cpuSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void run(int clients, const Settings& settings) {
  std::array<int, 2> port_pipe{}, report_pipe{};
  if (pipe(port_pipe.data()) != 0 || pipe(report_pipe.data()) != 0) return std::perror("bench_fanout: pipe");
  const pid_t child = fork();
  if (child == 0) {
    std::uint16_t port = 0;
    if (read(port_pipe[0], &port, sizeof port) == sizeof port) receive(port, clients, report_pipe[1]);
    std::_Exit(0);
  }
  const MonotonicClock clock;
  SessionConfig session;
  session.scene.name = "laboratory";
  session.period_ns = static_cast<std::int64_t>(1e9 / settings.rate_hz);
  if (settings.multicast) session.multicast = {"239.255.74.31", 7433};
  Broadcaster broadcaster({.port = 0, .max_clients = 1024}, session, clock);
  const std::uint16_t port = broadcaster.port();
  if (write(port_pipe[1], &port, sizeof port) != sizeof port) return;
  const auto last = static_cast<std::uint64_t>((settings.seconds + 2.0) * settings.rate_hz);
  const auto first = static_cast<std::uint64_t>(2.0 * settings.rate_hz);  // until all are there
  MovingMaster master(settings.rate_hz);
  double begun = 0.0;
  SamplingThread sampling(session.period_ns, [&](const SamplingTick& tick) {
    if (begun == 0.0 && tick.tick >= first) begun = cpuSeconds();
    master.sample(clock.nowNs());
    broadcaster.publish(master.world(), master.motion(), master.newFrame());
    return tick.tick < last;
  });
  sampling.join();
  const double cpu = (cpuSeconds() - begun) / settings.seconds;
  Received received;
  if (read(report_pipe[0], &received, sizeof received) != sizeof received) fmt::print("no report\n");
  waitpid(child, nullptr, 0);
  for (const int fd : {port_pipe[0], port_pipe[1], report_pipe[0], report_pipe[1]}) close(fd);
  fmt::print(
      "{:4} clients ({} by multicast): server {:5.1f} % of a core, missed {} periods, received {}, lost {}\n",
      clients, received.by_multicast, 100.0 * cpu, sampling.jitter().missed.load(), received.packets,
      received.lost);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  std::vector<int> clients{1, 2, 4, 8, 16, 32, 64};
  CLI::App app{"The server's cost as clients grow, and what they lose."};
  app.add_option("--rate", settings.rate_hz, "samples a second [1000]");
  app.add_option("--seconds", settings.seconds, "length of each run [4]");
  app.add_option("--clients", clients, "how many, as 1,8,64")->delimiter(',');
  app.add_flag("--multicast", settings.multicast, "motion goes to a group");
  CLI11_PARSE(app, argc, argv);
  for (const int n : clients) run(n, settings);
  return 0;
}
