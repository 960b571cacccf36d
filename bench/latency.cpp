// One-way latency from a sample being taken to its being decoded in a client's process, beside a bare UDP
// pair in the same run: two processes, loopback, a packet of each kind in turn on one schedule.
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <arpa/inet.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/sync/Clock.h"
#include "common/sync/DurationHistogram.h"
#include "motion_server/broadcast/Broadcaster.h"
#include "motion_server/sampling/SamplingThread.h"
#include "render_client/receive/ServerLink.h"

namespace {

using namespace coherency;

constexpr std::size_t kBareBytes = 336;  // no more than a motion packet with two redundant samples has

int udpSocket() {
  const int fd = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (fd < 0 || bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    std::perror("bench_latency: udp socket");
    std::exit(1);
  }
  return fd;
}

/// Blocking receiver of bare datagrams that carry the time of their sending; an empty one ends it.
void receiveBare(int fd, const Clock& clock, DurationHistogram& latency) {
  std::array<std::int64_t, kBareBytes / 8> datagram{};
  while (recv(fd, datagram.data(), kBareBytes, 0) > 0) latency.add(clock.nowNs() - datagram[0]);
}

std::string line(const char* what, const DurationHistogram& h) {
  return fmt::format("{:<34} p50 {:7.1f} us   p99 {:7.1f} us   max {:8.1f} us   ({} packets)", what,
                     static_cast<double>(h.quantile(0.5)) / 1e3, static_cast<double>(h.quantile(0.99)) / 1e3,
                     static_cast<double>(h.max()) / 1e3, h.count());
}

/// The client's process: a ServerLink, and the bare receiver beside it.
int receive(std::uint16_t port, int bare_fd) {
  const MonotonicClock clock;
  DurationHistogram bare, decoded, woken;
  ServerLink link({"127.0.0.1", port, "mono"}, clock);
  link.waitForSession(5'000'000'000);
  std::thread bare_thread([&] { receiveBare(bare_fd, clock, bare); });
  std::uint64_t tick = 0;
  while (link.waitForTick(tick + 1, 500'000'000)) {
    const auto packet = link.newest();
    const std::int64_t now_ns = clock.nowNs();
    tick = packet->packet.world.tick;
    decoded.add(packet->decoded.ns - packet->packet.sample.server_time_ns);
    woken.add(now_ns - packet->packet.sample.server_time_ns);
  }
  bare_thread.join();
  const auto ratio = [&](double q) {
    return static_cast<double>(decoded.quantile(q)) / static_cast<double>(bare.quantile(q));
  };
  fmt::print("{}\n{}\n{}\n", line("bare UDP, blocking receiver", bare),
             line("sample taken to decoded", decoded), line("sample taken to a waiting thread", woken));
  fmt::print("ratio to bare UDP: {:.2f} at the median, {:.2f} at p99; lost {}\n", ratio(0.5), ratio(0.99),
             link.stats().lost);
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

  // The socket is made before the fork and the server after it, so that each process has one end of each
  // pair.
  const int bare_receiver = udpSocket();
  std::array<int, 2> port_pipe{};
  if (pipe(port_pipe.data()) != 0) return 1;
  const pid_t child = fork();
  if (child == 0) {
    std::uint16_t port = 0;
    if (read(port_pipe[0], &port, sizeof port) != sizeof port) return 1;
    return receive(port, bare_receiver);
  }
  const MonotonicClock clock;
  SessionConfig session;
  session.scene.name = "laboratory";
  BroadcastConfig config;
  config.port = 0;
  Broadcaster broadcaster(config, session, clock);
  const std::uint16_t port = broadcaster.port();
  if (write(port_pipe[1], &port, sizeof port) != sizeof port) return 1;

  sockaddr_in bare_address{};
  socklen_t length = sizeof bare_address;
  getsockname(bare_receiver, reinterpret_cast<sockaddr*>(&bare_address), &length);
  const int bare_sender = udpSocket();
  std::array<std::int64_t, kBareBytes / 8> datagram{};
  const auto last = static_cast<std::uint64_t>(seconds * 2.0 * rate_hz);
  WorldState world;
  MotionSample sample;
  sample.valid = kAllDofs;
  SamplingThread sampling(static_cast<std::int64_t>(0.5e9 / rate_hz), [&](const SamplingTick& tick) {
    if (tick.tick % 2 == 0) {
      world.tick = tick.tick;
      ++sample.sequence;
      sample.server_time_ns = clock.nowNs();
      broadcaster.publish(world, sample);
    } else {
      datagram[0] = clock.nowNs();
      sendto(bare_sender, datagram.data(), kBareBytes, 0, reinterpret_cast<const sockaddr*>(&bare_address),
             length);
    }
    return tick.tick < last;
  });
  sampling.join();
  for (int i = 0; i < 3; ++i)
    sendto(bare_sender, datagram.data(), 0, 0, reinterpret_cast<const sockaddr*>(&bare_address), length);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}
