#include "tests/relay/UdpRelay.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <span>
#include <stdexcept>
#include <vector>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/steady_timer.hpp>

namespace coherency {
namespace {

namespace asio = boost::asio;
using asio::ip::udp;
using boost::system::error_code;

enum Direction : std::uint32_t { kUp, kDown };

constexpr int kReceiveBuffer = 4 * 1024 * 1024;  // as much of it as the system allows
constexpr std::size_t kLargestDatagram = 65536;
constexpr std::size_t kMostWaitingBytes = 64 * 1024 * 1024;
constexpr std::int64_t kSweepsInSilence = 4;

struct Flow {
  Flow(asio::io_context& io, const udp::endpoint& from) : client(from), upstream(io) {}
  udp::endpoint client;
  udp::socket upstream;
  std::vector<Impairment> impairments;  // by direction
  std::int64_t heard_ns = 0;
  std::array<std::byte, kLargestDatagram> incoming;
};
using FlowPtr = std::shared_ptr<Flow>;

struct Waiting {
  FlowPtr flow;
  Direction direction;
  std::int64_t arrival_ns;
  std::vector<std::byte> bytes;
};

udp::endpoint udpEndpoint(const Endpoint& endpoint) {
  return {asio::ip::make_address(endpoint.host), endpoint.port};
}

void prepare(udp::socket& socket) {
  socket.non_blocking(true);
  error_code smaller_works_too;
  socket.set_option(udp::socket::receive_buffer_size(kReceiveBuffer), smaller_works_too);
}

}  // namespace

class UdpRelay::Impl {
 public:
  Impl(asio::io_context& io, const UdpRelayConfig& config, const ImpairmentSettings& settings,
       const Clock& clock)
      : io_(io),
        clock_(clock),
        config_(config),
        settings_(settings),
        begin_ns_(clock.nowNs()),
        front_(io),
        due_timer_(io),
        sweep_timer_(io) {
    listen();
    receiveFromClients();
    sweep();
  }

  void change(const ImpairmentSettings& settings) {
    settings_ = settings;
    for (auto& [client, flow] : flows_)
      for (Impairment& impairment : flow->impairments) impairment.change(settings, clock_.nowNs());
  }

  UdpRelayStats stats_;
  std::map<udp::endpoint, FlowPtr> flows_;

 private:
  void listen() {
    const udp::endpoint endpoint = udpEndpoint(config_.listen);
    try {
      front_.open(endpoint.protocol());
      front_.bind(endpoint);
      prepare(front_);
    } catch (const boost::system::system_error& e) {
      throw std::runtime_error("UDP " + describe(config_.listen) + ": " + e.code().message());
    }
  }

  /// Errors of a datagram socket tell of an earlier datagram's fate; the next one may come all the same.
  void receiveFromClients() {
    front_.async_receive_from(asio::buffer(incoming_), from_,
                              [this](const error_code& error, std::size_t size) {
                                if (!error) arrived(flowOf(from_), kUp, std::span(incoming_).first(size));
                                receiveFromClients();
                              });
  }

  void receiveFromServer(const FlowPtr& flow) {
    flow->upstream.async_receive(asio::buffer(flow->incoming),
                                 [this, flow](const error_code& error, std::size_t size) {
                                   if (!flow->upstream.is_open()) return;
                                   if (!error) arrived(flow, kDown, std::span(flow->incoming).first(size));
                                   receiveFromServer(flow);
                                 });
  }

  FlowPtr flowOf(const udp::endpoint& client) {
    if (const auto found = flows_.find(client); found != flows_.end()) return found->second;
    if (flows_.size() == kMostFlows) evict();
    const auto flow = std::make_shared<Flow>(io_, client);
    const udp::endpoint server = udpEndpoint(config_.server);
    flow->upstream.open(server.protocol());
    flow->upstream.connect(server);
    prepare(flow->upstream);
    const auto number = static_cast<std::uint32_t>(stats_.flows_opened++);
    for (const Direction direction : {kUp, kDown}) {
      const ImpairmentStream stream{config_.seed, number, direction};
      flow->impairments.emplace_back(stream, settings_, begin_ns_);
    }
    flows_.emplace(client, flow);
    receiveFromServer(flow);
    return flow;
  }

  void evict() {
    const auto silent = std::min_element(flows_.begin(), flows_.end(), [](const auto& a, const auto& b) {
      return a.second->heard_ns < b.second->heard_ns;
    });
    silent->second->upstream.close();
    flows_.erase(silent);
    ++stats_.flows_evicted;
  }

  void sweep() {
    const std::int64_t now_ns = clock_.nowNs();
    stats_.flows_expired += std::erase_if(flows_, [&](const auto& entry) {
      const FlowPtr& flow = entry.second;
      const bool silent = now_ns - flow->heard_ns > config_.flow_silence_ns;
      if (silent) flow->upstream.close();
      return silent;
    });
    sweep_timer_.expires_after(std::chrono::nanoseconds(config_.flow_silence_ns / kSweepsInSilence));
    sweep_timer_.async_wait([this](const error_code&) { sweep(); });
  }

  void arrived(const FlowPtr& flow, Direction direction, std::span<const std::byte> bytes) {
    const std::int64_t now_ns = clock_.nowNs();
    flow->heard_ns = now_ns;
    const DatagramFate fate = flow->impairments[direction].pass(now_ns, bytes.size());
    count(stats_.directions[direction], fate);
    Waiting waiting{flow, direction, now_ns, {bytes.begin(), bytes.end()}};
    if (fate.flipped_bit)
      waiting.bytes[*fate.flipped_bit / 8] ^= std::byte{1} << static_cast<int>(*fate.flipped_bit % 8);
    for (int i = 0; i < fate.copies; ++i) enqueue(fate.leaves_ns[static_cast<std::size_t>(i)], waiting);
    sendDue();
  }

  static void count(DirectionStats& stats, const DatagramFate& fate) {
    using Drop = DatagramFate::Drop;
    ++stats.datagrams;
    stats.lost += fate.drop == Drop::Loss;
    stats.in_burst += fate.drop == Drop::Burst;
    stats.blocked += fate.drop == Drop::Blocked;
    stats.duplicated += fate.copies == 2;
    stats.corrupted += fate.flipped_bit.has_value();
  }

  void enqueue(std::int64_t leaves_ns, const Waiting& waiting) {
    if (waiting_bytes_ + waiting.bytes.size() > kMostWaitingBytes) {
      ++stats_.directions[waiting.direction].not_sent;
      return;
    }
    waiting_bytes_ += waiting.bytes.size();
    waiting_.emplace(leaves_ns, waiting);
  }

  void sendDue() {
    while (!waiting_.empty() && waiting_.begin()->first <= clock_.nowNs()) {
      send(waiting_.begin()->second);
      waiting_bytes_ -= waiting_.begin()->second.bytes.size();
      waiting_.erase(waiting_.begin());
    }
    if (waiting_.empty()) return;
    // Setting the time ends the wait for an earlier one.
    due_timer_.expires_at(
        std::chrono::steady_clock::time_point(std::chrono::nanoseconds(waiting_.begin()->first)));
    due_timer_.async_wait([this](const error_code& error) {
      if (!error) sendDue();
    });
  }

  void send(const Waiting& datagram) {
    DirectionStats& stats = stats_.directions[datagram.direction];
    error_code error;
    if (datagram.direction == kUp)
      datagram.flow->upstream.send(asio::buffer(datagram.bytes), 0, error);
    else
      front_.send_to(asio::buffer(datagram.bytes), datagram.flow->client, 0, error);
    if (error) {
      ++stats.not_sent;
    } else {
      ++stats.sent;
      stats.delay.add(clock_.nowNs() - datagram.arrival_ns);
    }
  }

  asio::io_context& io_;
  const Clock& clock_;
  const UdpRelayConfig config_;
  ImpairmentSettings settings_;
  std::int64_t begin_ns_;  // of every flow's time
  udp::socket front_;
  udp::endpoint from_;
  std::array<std::byte, kLargestDatagram> incoming_;
  std::multimap<std::int64_t, Waiting> waiting_;  // by when they leave; equal ones in the order they came
  std::size_t waiting_bytes_ = 0;
  asio::steady_timer due_timer_, sweep_timer_;
};

UdpRelay::UdpRelay(asio::io_context& io, const UdpRelayConfig& config, const ImpairmentSettings& settings,
                   const Clock& clock)
    : impl_(std::make_unique<Impl>(io, config, settings, clock)) {}
UdpRelay::~UdpRelay() = default;
void UdpRelay::change(const ImpairmentSettings& settings) {
  impl_->change(settings);
}
const UdpRelayStats& UdpRelay::stats() const {
  return impl_->stats_;
}
std::size_t UdpRelay::flows() const {
  return impl_->flows_.size();
}

}  // namespace coherency
