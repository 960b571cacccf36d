#include <csignal>
#include <cstdio>
#include <exception>
#include <istream>

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/streambuf.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "common/config/LiveFile.h"
#include "common/sync/Clock.h"
#include "tests/relay/Options.h"
#include "tests/relay/Relay.h"

namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using namespace coherency;

constexpr std::size_t kLongestLine = 4096;

/// Lines of standard input, each obeyed and answered on standard output.
class Console {
 public:
  Console(asio::io_context& io, Relay& relay, bool end_with_it)
      : io_(io), relay_(relay), end_with_it_(end_with_it), input_(io, dup(STDIN_FILENO)) {
    read();
  }

 private:
  void read() {
    asio::async_read_until(input_, lines_, '\n', [this](const error_code& error, std::size_t) {
      if (error) {
        if (end_with_it_) io_.stop();
        return;
      }
      std::string line;
      std::istream stream(&lines_);
      std::getline(stream, line);
      fmt::print("{}\n", relay_.obey(line));
      std::fflush(stdout);
      read();
    });
  }

  asio::io_context& io_;
  Relay& relay_;
  bool end_with_it_;
  asio::posix::stream_descriptor input_;
  asio::streambuf lines_{kLongestLine};
};

void relay(const RelayOptions& options) {
  const MonotonicClock clock;
  asio::io_context io(1);
  asio::signal_set signals(io, SIGINT, SIGTERM);
  signals.async_wait([&](const error_code&, int) { io.stop(); });
  std::signal(SIGPIPE, SIG_IGN);  // who directs it may be gone before it
  Relay relay(io, options, clock);
  LiveFile statistics(options.stats_json, relay.statsJson() + "\n");
  Console console(io, relay, options.until_stdin_closes);
  fmt::print(stderr, "listening on {} for {}\n", describe(options.listen), describe(options.server));
  io.run();
  statistics.finish(relay.statsJson() + "\n");
}

}  // namespace

int main(int argc, char** argv) {
  int exit_code = -1;
  const RelayOptions options = parseRelayOptions(argc, argv, exit_code);
  if (exit_code >= 0) return exit_code;
  try {
    relay(options);
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "impairing_relay: {}\n", e.what());
    return 1;
  }
}
