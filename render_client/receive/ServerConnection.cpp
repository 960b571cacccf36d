#include "render_client/receive/ServerConnection.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>

#include "common/wire/ControlChannel.h"
#include "render_client/receive/LinkState.h"

namespace coherency {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using asio::ip::udp;
using boost::system::error_code;
using std::chrono::milliseconds;

constexpr auto kAnswerWithin = milliseconds(1000);  ///< to connect, and then to be welcomed
constexpr auto kReportEvery = milliseconds(200);
constexpr auto kBurstProbeEvery = milliseconds(5);
constexpr auto kProbeEvery = milliseconds(100);
constexpr int kBurstProbes = 8;
constexpr std::int64_t kSilenceNs = 1'500'000'000;
constexpr std::int64_t kUdpPatienceNs = 700'000'000;  ///< then TCP is tried, before silence is the end
constexpr std::int64_t kUdpRetryNs = 1'000'000'000;  ///< how soon UDP is tried again; twice as long each time
constexpr std::int64_t kUdpRetryMostNs = 60'000'000'000;
constexpr std::int64_t kGroupPatienceNs = 300'000'000;  ///< then the server is to send to us alone
constexpr int kDatagramsAtOnce = 256;                   ///< then timers and TCP have their turn
constexpr int kReceiveBuffer = 4 * 1024 * 1024;  ///< as much of it as the system allows: seconds of motion

/// Keeps itself alive through the handlers it waits in; after close() they do nothing.
class Connection final : public ServerConnection, public std::enable_shared_from_this<Connection> {
 public:
  Connection(asio::io_context& io, const LinkConfig& config, const Clock& clock, LinkState& state,
             OnEnd on_end)
      : config_(config),
        clock_(clock),
        state_(state),
        on_end_(std::move(on_end)),
        tcp_(io),
        udp_(io),
        group_(io),
        deadline_(io),
        probe_timer_(io),
        report_timer_(io),
        channel_(ControlChannel::Side::Client, config.key, randomKey()) {}

  void start(const tcp::endpoint& server) {
    server_ = server;
    deadline_.expires_after(kAnswerWithin);
    deadline_.async_wait([self = shared_from_this()](const error_code& error) {
      if (!error && !self->welcomed_) self->end("it does not answer");
    });
    tcp_.async_connect(server, [self = shared_from_this()](const error_code& error) {
      if (error) return self->end(error.message());
      error_code ignored;
      self->tcp_.set_option(tcp::no_delay(true), ignored);
      self->say(self->channel_.hello());
      self->read();
    });
  }

  void leave() override {
    if (welcomed_ && !closed_) sayAtOnce({"the client ends", GoodbyeCause::Leaving});
    close();
  }

  void request(const ModeRequest& wish) override {
    wish_ = wish;
    sayWishes();
  }
  void sayWishes() override {
    if (closed_ || !welcomed_ || !writing_.empty()) return;
    if (wish_) return say(*std::exchange(wish_, std::nullopt));
    if (state_.takeKeyframeWish()) say(KeyframeRequest{});
  }

  void close() {
    closed_ = true;
    error_code ignored;
    tcp_.close(ignored);
    udp_.close(ignored);
    group_.close(ignored);
    deadline_.cancel();
    probe_timer_.cancel();
    report_timer_.cancel();
  }

 private:
  ClientTime now() const { return {clock_.nowNs()}; }

  void end(const std::string& why) {
    if (closed_) return;
    close();
    on_end_(why);
  }

  /// Before closing: said if it can be said without waiting.
  void sayAtOnce(const Goodbye& goodbye) {
    if (!writing_.empty()) return;
    error_code ignored;
    tcp_.non_blocking(true, ignored);
    channel_.write(goodbye, writing_);
    tcp_.write_some(asio::buffer(writing_), ignored);
  }

  // Only one piece is ever under way: what would wait is not said at all.
  void say(const ControlMessage& message) {
    if (!writing_.empty()) return;
    channel_.write(message, writing_);
    asio::async_write(tcp_, asio::buffer(writing_),
                      [self = shared_from_this()](const error_code& error, std::size_t) {
                        self->writing_.clear();
                        if (error) return self->end(error.message());
                        self->sayWishes();
                      });
  }

  void read() {
    tcp_.async_read_some(
        asio::buffer(incoming_), [self = shared_from_this()](const error_code& error, std::size_t size) {
          if (error)
            return self->end(error == asio::error::eof ? "the connection was closed" : error.message());
          self->onBytes(size);
          if (!self->closed_) self->read();
        });
  }

  void onBytes(std::size_t size) {
    channel_.feed(std::span(incoming_).first(size));
    while (!closed_) {
      const auto message = channel_.next();
      if (!message) break;
      if (const auto* const reject = std::get_if<Reject>(&*message))
        refuse(*reject);
      else
        std::visit([this](const auto& said) { on(said); }, std::get<ControlMessage>(*message));
    }
    if (channel_.oversized()) refuse(Reject::Oversized);
  }

  void on(const Hello& hello) {
    if (hello.major != kWireMajor) return refuseVersion();
    const bool keyed = config_.key != kNoKey;
    if (hello.keyed != keyed)
      return refuseKey(keyed ? "it has no key: leave --key out, or start it with the key" : "it wants a key");
    if (!channel_.agree(hello)) return refuse(Reject::Malformed);
    say(Join{config_.eye, "coherency render_client"});
  }
  void on(const SessionConfig& session) {
    if (welcomed_) return end("a second welcome came");
    if (!channel_.proven()) return refuse(Reject::Malformed);
    welcomed_ = true;
    deadline_.cancel();
    state_.welcomed(session, channel_.keys());
    if (!openUdp(session.udp_port)) return;
    if (session.multicast) openGroup(*session.multicast);
    heard_ = udp_heard_ = udp_motion_ = now();
    receive(udp_);
    probe(kBurstProbes);
    report();
  }
  void on(const Keyframe& keyframe) { state_.take(keyframe); }
  void on(const Tunnelled& tunnelled) {
    const ClientTime arrived = now();
    if (welcomed_ && state_.tunnelled(tunnelled, arrived) >= LinkState::Heard::Reply) heard_ = arrived;
  }
  void on(const Goodbye& goodbye) {
    state_.refused(goodbye);
    end(goodbye.reason);
  }
  void on(const Join&) { refuse(Reject::Malformed); }
  void on(const ClientReport&) { refuse(Reject::Malformed); }
  void on(const ModeRequest&) { refuse(Reject::Malformed); }
  void on(const KeyframeRequest&) { refuse(Reject::Malformed); }

  void refuse(Reject reject) {
    if (reject == Reject::Forged && !channel_.proven()) return refuseKey("it has another key");
    sayAtOnce({"not a control message that a server sends", GoodbyeCause::Protocol});
    end("what answers there is no motion server");
  }
  void refuseVersion() {
    state_.refuseVersion();
    sayAtOnce({"this client speaks another major version", GoodbyeCause::Version});
    end("it speaks another version");
  }
  void refuseKey(const std::string& why) {
    state_.refused({why, GoodbyeCause::Key});
    sayAtOnce({"this client has another key, or none", GoodbyeCause::Key});
    end(why);
  }

  bool openUdp(std::uint16_t port) {
    error_code error;
    const udp::endpoint server(server_.address(), port);
    udp_.open(server.protocol(), error);
    if (!error) udp_.connect(server, error);
    if (!error) udp_.non_blocking(true, error);
    if (error) {
      end("UDP: " + error.message());
      return false;
    }
    udp_.set_option(udp::socket::receive_buffer_size(kReceiveBuffer), error);  // smaller ones work too
    return true;
  }

  /// Asked for when it is heard, as the server offers it now and then. Where it does not work or stays silent
  /// the server sends to us alone.
  void openGroup(const MulticastGroup& group) {
    error_code error;
    const auto address = asio::ip::make_address_v4(group.address, error);
    const auto own = tcp_.local_endpoint(error).address();
    if (error || !own.is_v4()) return;
    group_.open(udp::v4(), error);
    group_.set_option(udp::socket::reuse_address(true), error);
    if (!error) group_.bind({address, group.port}, error);
    if (!error) group_.set_option(asio::ip::multicast::join_group(address, own.to_v4()), error);
    if (!error) group_.non_blocking(true, error);
    if (error) return;
    group_.set_option(udp::socket::receive_buffer_size(kReceiveBuffer), error);
    receive(group_);
  }

  void receive(udp::socket& socket) {
    socket.async_wait(udp::socket::wait_read, [self = shared_from_this(), &socket](const error_code& error) {
      if (self->closed_ || (error && !socket.is_open())) return;
      self->drain(socket);
      self->receive(socket);
    });
  }

  void drain(udp::socket& socket) {
    for (int i = 0; i < kDatagramsAtOnce; ++i) {
      error_code error;
      const std::size_t size = socket.receive(asio::buffer(datagram_), 0, error);
      if (error) return;  // nothing more; or the port is closed over there, which silence or TCP will tell
      const ClientTime arrived = now();
      const LinkState::Heard heard = state_.datagram(std::span(datagram_).first(size), arrived);
      const bool by_group = &socket == &group_;
      // The group is heard where its copy comes second, too; else whoever repeats what was said is not
      // believed.
      if (by_group && heard != LinkState::Heard::Nothing) group_heard_ = arrived;
      if (heard < LinkState::Heard::Reply) continue;
      heard_ = arrived;
      if (!by_group) hearUdp(heard == LinkState::Heard::Motion, arrived);
    }
  }

  /// Small datagrams may pass where motion does not: it is motion that UDP is judged by, once it was asked
  /// for.
  void hearUdp(bool motion, ClientTime arrived) {
    udp_heard_ = arrived;
    if (motion || way_ != MotionWay::Udp) udp_motion_ = arrived;
    if (motion) udp_retry_ns_ = kUdpRetryNs / 2;
  }

  /// UDP as long as motion is heard by it; the group where that is, and probes are answered; else TCP, and
  /// now and then UDP is tried again.
  MotionWay chooseWay() const {
    const ClientTime at = now();
    if (at - udp_heard_ >= kUdpPatienceNs) return MotionWay::Tcp;
    if (group_heard_.ns != 0 && at - group_heard_ < kGroupPatienceNs) return MotionWay::Multicast;
    return at - udp_motion_ < kUdpPatienceNs ? MotionWay::Udp : MotionWay::Tcp;
  }

  void probe(int burst_left) {
    if (now() - heard_ > kSilenceNs) return end("it fell silent");
    const MotionWay way = chooseWay();
    if (way == MotionWay::Tcp && way_ != way) udp_retry_ns_ = std::min(2 * udp_retry_ns_, kUdpRetryMostNs);
    way_ = way;
    state_.setWay(way);
    if (way == MotionWay::Tcp) say(state_.tunnelledProbe());
    if (way != MotionWay::Tcp || now() - udp_tried_ >= udp_retry_ns_) {
      udp_tried_ = now();
      state_.encodeProbe(way, probe_bytes_);
      error_code ignored;
      udp_.send(asio::buffer(probe_bytes_), 0, ignored);
    }
    probe_timer_.expires_after(burst_left > 1 ? kBurstProbeEvery : kProbeEvery);
    probe_timer_.async_wait([self = shared_from_this(), burst_left](const error_code&) {
      if (!self->closed_) self->probe(burst_left > 1 ? burst_left - 1 : 0);
    });
  }

  void report() {
    report_timer_.expires_after(kReportEvery);
    report_timer_.async_wait([self = shared_from_this()](const error_code&) {
      if (self->closed_) return;
      self->sayWishes();
      if (self->writing_.empty()) self->say(self->state_.takeReport());
      self->report();
    });
  }

  const LinkConfig& config_;
  const Clock& clock_;
  LinkState& state_;
  OnEnd on_end_;
  tcp::endpoint server_;
  tcp::socket tcp_;
  udp::socket udp_;
  udp::socket group_;
  asio::steady_timer deadline_;
  asio::steady_timer probe_timer_;
  asio::steady_timer report_timer_;
  ControlChannel channel_;
  std::array<std::byte, 4096> incoming_{};
  std::array<std::byte, 2 * kMaxDatagram> datagram_{};
  std::vector<std::byte> writing_;
  std::vector<std::byte> probe_bytes_;
  std::optional<ModeRequest> wish_;
  ClientTime heard_;
  MotionWay way_ = MotionWay::Udp;
  ClientTime udp_heard_;   ///< by UDP to us alone: motion or replies
  ClientTime udp_motion_;  ///< motion
  std::int64_t udp_retry_ns_ = kUdpRetryNs / 2;
  ClientTime udp_tried_;
  ClientTime group_heard_;
  bool welcomed_ = false;
  bool closed_ = false;
};

}  // namespace

std::shared_ptr<ServerConnection> connectTo(const std::string& address, asio::io_context& io,
                                            const LinkConfig& config, const Clock& clock, LinkState& state,
                                            ServerConnection::OnEnd on_end) {
  auto connection = std::make_shared<Connection>(io, config, clock, state, std::move(on_end));
  connection->start({asio::ip::make_address(address), config.port});
  return connection;
}

}  // namespace coherency
