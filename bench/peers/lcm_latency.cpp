// One-way latency of LCM's UDP multicast from publishing to its handler in another process, beside a bare UDP
// pair of the same payload in the same run, as bench_latency has it for this project's chain. Huang, Olson,
// Moore, "LCM: Lightweight Communications and Marshalling", IROS 2010. lcm.sh gives it a network that is all
// its own.
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <lcm/lcm.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/BarePair.h"
#include "common/config/CommandLine.h"
#include "common/sync/Clock.h"
#include "common/sync/DurationHistogram.h"
#include "motion_server/sampling/SamplingThread.h"

namespace {

using namespace coherency;

constexpr char kChannel[] = "MOTION";
constexpr int kEnds = 3;
constexpr int kPatienceMs = 2000;

struct Options {
  double seconds = 10.0;
  double rate_hz = 1000.0;
  std::size_t bytes = 500;
  std::string provider = "udpm://239.255.76.67:7667?ttl=0";
};

/// What a message begins with; a shorter one is the end.
struct Stamp {
  std::int64_t sent_ns = 0;
  std::uint64_t number = 0;
};

class Lcm {
 public:
  explicit Lcm(const std::string& provider) : lcm_(lcm_create(provider.c_str())) {
    if (lcm_ == nullptr)
      throw std::runtime_error(provider +
                               ": LCM cannot use it; is there a route for multicast? "
                               "bench/peers/lcm.sh makes one");
  }
  ~Lcm() { lcm_destroy(lcm_); }
  Lcm(const Lcm&) = delete;
  Lcm& operator=(const Lcm&) = delete;
  lcm_t* get() const { return lcm_; }

 private:
  lcm_t* lcm_;
};

struct Receiver {
  MonotonicClock clock;
  DurationHistogram latency;
  std::uint64_t newest = 0;
  bool ended = false;
};

void onMessage(const lcm_recv_buf_t* message, const char*, void* user) {
  auto& receiver = *static_cast<Receiver*>(user);
  Stamp stamp;
  if (message->data_size < sizeof stamp) {
    receiver.ended = true;
    return;
  }
  std::memcpy(&stamp, message->data, sizeof stamp);
  receiver.latency.add(receiver.clock.nowNs() - stamp.sent_ns);
  receiver.newest = stamp.number;
}

void receive(const Options& options, BarePair& bare_pair, int ready_pipe) {
  Receiver receiver;
  DurationHistogram bare;
  const Lcm lcm(options.provider);
  if (lcm_subscribe(lcm.get(), kChannel, onMessage, &receiver) == nullptr)
    throw std::runtime_error(options.provider +
                             ": LCM hears nothing of itself; bench/peers/lcm.sh makes a network");
  if (write(ready_pipe, "r", 1) != 1) throw std::runtime_error("the sender is gone");
  std::thread bare_thread([&] { bare_pair.receive(receiver.clock, bare); });
  while (!receiver.ended && lcm_handle_timeout(lcm.get(), kPatienceMs) > 0) {
  }
  bare_thread.join();
  fmt::print("{}\n{}\n", latencyLine("bare UDP, blocking receiver", bare),
             latencyLine("LCM, published to handled", receiver.latency));
  fmt::print("ratio to bare UDP: {}; lost {} of {} messages of {} bytes\n",
             latencyRatio(receiver.latency, bare), receiver.newest - receiver.latency.count(),
             receiver.newest, options.bytes);
}

void send(const Options& options, BarePair& bare) {
  const MonotonicClock clock;
  const Lcm lcm(options.provider);
  std::vector<std::byte> message(options.bytes);
  Stamp stamp;
  const auto last = 2 * static_cast<std::uint64_t>(options.seconds * options.rate_hz);
  SamplingThread sampling(static_cast<std::int64_t>(0.5e9 / options.rate_hz), [&](const SamplingTick& tick) {
    if (tick.tick % 2 == 0) {
      stamp.sent_ns = clock.nowNs();
      ++stamp.number;
      std::memcpy(message.data(), &stamp, sizeof stamp);
      lcm_publish(lcm.get(), kChannel, message.data(), static_cast<unsigned>(message.size()));
    } else {
      bare.send(clock);
    }
    return tick.tick < last;
  });
  sampling.join();
  bare.end();
  for (int i = 0; i < kEnds; ++i) lcm_publish(lcm.get(), kChannel, message.data(), 1);
}

int run(const Options& options) {
  // LCM has threads: it is made after the fork, on either side.
  BarePair bare(options.bytes);
  std::array<int, 2> ready_pipe{};
  if (pipe(ready_pipe.data()) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0) {
    receive(options, bare, ready_pipe[1]);
    return 0;
  }
  close(ready_pipe[1]);
  char ready = 0;
  if (read(ready_pipe[0], &ready, 1) == 1) send(options, bare);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"One-way latency of LCM, beside a bare UDP pair in the same run."};
  app.add_option("--seconds", options.seconds, "length of the run [10]")->check(finite(0.1, 3600.0));
  app.add_option("--rate", options.rate_hz, "messages a second, and as many bare packets between them [1000]")
      ->check(finite(1.0, 1e5));
  app.add_option("--bytes", options.bytes, "of a message, and of a bare packet [500]")
      ->check(whole(sizeof(Stamp), 60000));
  app.add_option("--provider", options.provider, "LCM's URL [udpm://239.255.76.67:7667?ttl=0]");
  if (const int code = parseArguments(app, argc, argv, "bench_lcm_latency"); code >= 0) return code;
  try {
    return run(options);
  } catch (const std::exception& e) {
    fmt::print(stderr, "bench_lcm_latency: {}\n", e.what());
    return 1;
  }
}
