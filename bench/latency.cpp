// One-way latency from a sample being taken to its being decoded in a client's process, beside a bare UDP
// pair in the same run: two processes, loopback, a packet of each kind in turn on one schedule.
#include <array>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/BarePair.h"
#include "bench/MovingMaster.h"
#include "common/sync/Clock.h"
#include "common/sync/DurationHistogram.h"
#include "motion_server/broadcast/Broadcaster.h"
#include "motion_server/sampling/SamplingThread.h"
#include "render_client/receive/ServerLink.h"

namespace {

using namespace coherency;

constexpr std::size_t kBareBytes =
    640;  // as a motion packet with two redundant samples and two frames, sealed

/// The client's process: a ServerLink, and the bare receiver beside it.
int receive(std::uint16_t port, BarePair& bare_pair) {
  const MonotonicClock clock;
  DurationHistogram bare, decoded, woken;
  ServerLink link({"127.0.0.1", port, "mono"}, clock);
  link.waitForSession(5'000'000'000);
  std::thread bare_thread([&] { bare_pair.receive(clock, bare); });
  std::uint64_t tick = 0;
  while (link.waitForTick(tick + 1, 500'000'000)) {
    const auto packet = link.newest();
    const std::int64_t now_ns = clock.nowNs();
    tick = packet->packet.world.tick;
    decoded.add(packet->decoded.ns - packet->packet.sample.server_time_ns);
    woken.add(now_ns - packet->packet.sample.server_time_ns);
  }
  bare_thread.join();
  fmt::print("{}\n{}\n{}\n", latencyLine("bare UDP, blocking receiver", bare),
             latencyLine("sample taken to decoded", decoded),
             latencyLine("sample taken to a waiting thread", woken));
  fmt::print("ratio to bare UDP: {}; lost {}\n", latencyRatio(decoded, bare), link.stats().lost);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  double seconds = 10.0;
  double rate_hz = 1000.0;
  CLI::App app{"One-way latency of motion, beside a bare UDP pair in the same run."};
  app.add_option("--seconds", seconds, "length of the run [10]");
  app.add_option("--rate", rate_hz, "samples a second, and as many bare packets between them [1000]");
  CLI11_PARSE(app, argc, argv);

  // The pair is made before the fork and the server after it, so that each process has one end of each.
  BarePair bare(kBareBytes);
  std::array<int, 2> port_pipe{};
  if (pipe(port_pipe.data()) != 0) return 1;
  const pid_t child = fork();
  if (child == 0) {
    std::uint16_t port = 0;
    if (read(port_pipe[0], &port, sizeof port) != sizeof port) return 1;
    return receive(port, bare);
  }
  const MonotonicClock clock;
  SessionConfig session;
  session.scene.name = "laboratory";
  BroadcastConfig config;
  config.port = 0;
  Broadcaster broadcaster(config, session, clock);
  const std::uint16_t port = broadcaster.port();
  if (write(port_pipe[1], &port, sizeof port) != sizeof port) return 1;

  const auto last = static_cast<std::uint64_t>(seconds * 2.0 * rate_hz);
  MovingMaster master(rate_hz);
  SamplingThread sampling(static_cast<std::int64_t>(0.5e9 / rate_hz), [&](const SamplingTick& tick) {
    if (tick.tick % 2 == 0) {
      master.sample(clock.nowNs());
      broadcaster.publish(master.world(), master.motion(), master.newFrame());
    } else {
      bare.send(clock);
    }
    return tick.tick < last;
  });
  sampling.join();
  bare.end();
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}
