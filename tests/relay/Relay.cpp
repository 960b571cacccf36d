#include "tests/relay/Relay.h"

#include <nlohmann/json.hpp>

namespace coherency {
namespace {

using nlohmann::json;

json toJson(const DirectionStats& stats, std::uint64_t tcp_bytes) {
  const Spread delay = spread(stats.delay, 1e6);
  return {{"datagrams", stats.datagrams},
          {"dropped", {{"loss", stats.lost}, {"burst", stats.in_burst}, {"blocked", stats.blocked}}},
          {"duplicated", stats.duplicated},
          {"corrupted", stats.corrupted},
          {"sent", stats.sent},
          {"not_sent", stats.not_sent},
          {"delay_ms", {{"p50", delay.p50}, {"p99", delay.p99}, {"max", delay.max}}},
          {"tcp_bytes", tcp_bytes}};
}

}  // namespace

Relay::Relay(boost::asio::io_context& io, const RelayOptions& options, const Clock& clock)
    : settings_(options.settings),
      udp_(io, {options.listen, options.server, options.seed, options.flow_silence_ns}, options.settings.udp,
           clock),
      tcp_(io, options.listen, options.server, options.settings.tcp_delay_ns, clock) {}

std::string Relay::obey(const std::string& line) {
  if (line == "stats") return statsJson();
  if (line == "cut") {
    tcp_.cut();
  } else if (line == "impair on" || line == "impair off") {
    impairing_ = line == "impair on";
    apply();
  } else if (const std::string wrong = changeSetting(line, settings_); !wrong.empty()) {
    return "error: " + wrong;
  } else {
    apply();
  }
  return "ok";
}

void Relay::apply() {
  const RelaySettings now = impairing_ ? settings_ : RelaySettings{};
  udp_.change(now.udp);
  tcp_.change(now.tcp_delay_ns);
}

std::string Relay::statsJson() const {
  const UdpRelayStats& udp = udp_.stats();
  const TcpRelayStats& tcp = tcp_.stats();
  return json{{"up", toJson(udp.directions[0], tcp.bytes[0])},
              {"down", toJson(udp.directions[1], tcp.bytes[1])},
              {"flows",
               {{"opened", udp.flows_opened},
                {"expired", udp.flows_expired},
                {"evicted", udp.flows_evicted},
                {"open", udp_.flows()}}},
              {"tcp", {{"connections", tcp.connections}, {"refused", tcp.refused}, {"cut", tcp.cut}}}}
      .dump();
}

}  // namespace coherency
