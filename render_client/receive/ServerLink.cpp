#include "render_client/receive/ServerLink.h"

#include <array>
#include <functional>
#include <thread>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>

#include "common/wire/ControlCodec.h"
#include "common/wire/ControlFraming.h"
#include "render_client/receive/LinkState.h"
#include "render_client/receive/NameLookup.h"

namespace coherency {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using asio::ip::udp;
using boost::system::error_code;
using std::chrono::milliseconds;

constexpr auto kReconnectAfter = milliseconds(200);
constexpr auto kAnswerWithin = milliseconds(1000);  ///< to connect, and then to be welcomed
constexpr auto kReportEvery = milliseconds(500);
constexpr auto kBurstProbeEvery = milliseconds(5);
constexpr auto kProbeEvery = milliseconds(100);
constexpr int kBurstProbes = 8;
constexpr std::int64_t kSilenceNs = 1'000'000'000;
constexpr int kDatagramsAtOnce = 256;            ///< then timers and TCP have their turn
constexpr int kReceiveBuffer = 4 * 1024 * 1024;  ///< as much of it as the system allows: seconds of motion

/// One connection to one address, from the first packet to the last; a new attempt is a new object. It keeps
/// itself alive through the handlers it waits in; after close() they do nothing.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  using OnEnd = std::function<void(const std::string& why)>;

  Connection(asio::io_context& io, const LinkConfig& config, const Clock& clock, LinkState& state,
             OnEnd on_end)
      : config_(config),
        clock_(clock),
        state_(state),
        on_end_(std::move(on_end)),
        tcp_(io),
        udp_(io),
        deadline_(io),
        probe_timer_(io),
        report_timer_(io) {}

  void start(const tcp::endpoint& server) {
    server_ = server;
    deadline_.expires_after(kAnswerWithin);
    deadline_.async_wait([self = shared_from_this()](const error_code& error) {
      if (!error) self->end("it does not answer");
    });
    tcp_.async_connect(server, [self = shared_from_this()](const error_code& error) {
      if (error) return self->end(error.message());
      error_code ignored;
      self->tcp_.set_option(tcp::no_delay(true), ignored);
      self->write(encodeControl(Hello{kWireMajor, kWireMinor, self->config_.eye, "coherency render_client"}));
      self->read();
    });
  }

  void leave() {
    if (welcomed_ && !closed_) sayAtOnce({"the client ends", GoodbyeCause::Leaving});
    close();
  }

  /// Unlike reports, a wish is said sooner or later, the newest one.
  void request(const ModeRequest& wish) {
    wish_ = wish;
    sayWish();
  }

  void close() {
    closed_ = true;
    error_code ignored;
    tcp_.close(ignored);
    udp_.close(ignored);
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
    tcp_.write_some(asio::buffer(encodeControl(goodbye)), ignored);
  }

  // Only one piece is ever under way: what would wait is not said at all.
  void write(std::vector<std::byte> bytes) {
    if (!writing_.empty()) return;
    writing_ = std::move(bytes);
    asio::async_write(tcp_, asio::buffer(writing_),
                      [self = shared_from_this()](const error_code& error, std::size_t) {
                        self->writing_.clear();
                        if (error) return self->end(error.message());
                        self->sayWish();
                      });
  }

  void sayWish() {
    if (!wish_ || closed_ || !welcomed_ || !writing_.empty()) return;
    const ModeRequest wish = *wish_;
    wish_.reset();
    write(encodeControl(wish));
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
    framing_.feed(std::span(incoming_).first(size));
    while (!closed_) {
      const auto message = framing_.next();
      if (!message) break;
      std::visit([this](const auto& decoded) { on(decoded); }, decodeControl(*message));
    }
    if (framing_.oversized()) on(Reject::Oversized);
  }

  void on(const SessionConfig& session) {
    if (welcomed_) return end("a second welcome came");
    welcomed_ = true;
    deadline_.cancel();
    state_.welcomed(session);
    if (!openUdp(session.udp_port)) return;
    heard_ = now();
    receive();
    probe(kBurstProbes);
    report();
  }
  void on(const Goodbye& goodbye) {
    state_.refused(goodbye);
    end(goodbye.reason);
  }
  void on(Reject reject) {
    const bool version = reject == Reject::Version;
    if (version) state_.refuseVersion();
    sayAtOnce(version ? Goodbye{"this client speaks another major version", GoodbyeCause::Version}
                      : Goodbye{"not a control message that a server sends", GoodbyeCause::Protocol});
    end(version ? "it speaks another version" : "what answers there is no motion server");
  }
  void on(const Hello&) { on(Reject::Malformed); }
  void on(const ClientReport&) { on(Reject::Malformed); }
  void on(const ModeRequest&) { on(Reject::Malformed); }

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

  void receive() {
    udp_.async_wait(udp::socket::wait_read, [self = shared_from_this()](const error_code&) {
      if (self->closed_) return;
      self->drain();
      self->receive();
    });
  }

  void drain() {
    for (int i = 0; i < kDatagramsAtOnce; ++i) {
      error_code error;
      const std::size_t size = udp_.receive(asio::buffer(datagram_), 0, error);
      if (error) return;  // nothing more; or the port is closed over there, which silence or TCP will tell
      const ClientTime arrived = now();
      if (state_.datagram(std::span(datagram_).first(size), arrived)) heard_ = arrived;
    }
  }

  void probe(int burst_left) {
    if (now() - heard_ > kSilenceNs) return end("it fell silent");
    codec_.encode(state_.probe(), probe_bytes_);
    error_code ignored;
    udp_.send(asio::buffer(probe_bytes_), 0, ignored);
    probe_timer_.expires_after(burst_left > 1 ? kBurstProbeEvery : kProbeEvery);
    probe_timer_.async_wait([self = shared_from_this(), burst_left](const error_code&) {
      if (!self->closed_) self->probe(burst_left > 1 ? burst_left - 1 : 0);
    });
  }

  void report() {
    report_timer_.expires_after(kReportEvery);
    report_timer_.async_wait([self = shared_from_this()](const error_code&) {
      if (self->closed_) return;
      if (self->writing_.empty()) self->write(encodeControl(self->state_.takeReport()));
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
  asio::steady_timer deadline_;
  asio::steady_timer probe_timer_;
  asio::steady_timer report_timer_;
  ControlFraming framing_;
  DatagramCodec codec_;
  std::array<std::byte, 4096> incoming_{};
  std::array<std::byte, 2 * kMaxDatagram> datagram_{};
  std::vector<std::byte> writing_;
  std::vector<std::byte> probe_bytes_;
  std::optional<ModeRequest> wish_;
  ClientTime heard_;
  bool welcomed_ = false;
  bool closed_ = false;
};

}  // namespace

/// Looks the name up, tries its addresses one after the other, and begins again when the connection ends.
class ServerLink::Impl {
 public:
  Impl(const LinkConfig& config, const Clock& clock) : config_(config), clock_(clock), state_(config, clock) {
    lookUp();
    thread_ = std::thread([this] { io_->run(); });
  }

  ~Impl() {
    asio::post(*io_, [this] {
      if (connection_) connection_->leave();
      io_->stop();
    });
    thread_.join();
    connection_.reset();
  }

  void request(const ModeRequest& wish) {
    asio::post(*io_, [this, wish] {
      if (connection_) connection_->request(wish);
    });
  }

  LinkState& state() { return state_; }
  const LinkState& state() const { return state_; }

 private:
  void lookUp() {
    // The lookup may outlast the link: it holds the io_context, which then has nobody who runs it.
    lookUpName(config_.host, [this, io = io_](const NameAnswer& answer) {
      asio::post(*io, [this, answer] { onAddresses(answer); });
    });
  }

  void onAddresses(const NameAnswer& answer) {
    addresses_ = answer.addresses;
    next_address_ = 0;
    connectNext("cannot find the host: " + answer.error);
  }

  void connectNext(const std::string& why) {
    if (next_address_ == addresses_.size()) return again(why);
    error_code error;
    const auto address = asio::ip::make_address(addresses_[next_address_++], error);
    if (error) return connectNext(error.message());
    connection_ =
        std::make_shared<Connection>(*io_, config_, clock_, state_, [this](const std::string& reason) {
          state_.disconnected(reason);
          connectNext(reason);
        });
    connection_->start({address, config_.port});
  }

  void again(const std::string& why) {
    state_.disconnected(why);
    reconnect_timer_.expires_after(kReconnectAfter);
    reconnect_timer_.async_wait([this](const error_code& error) {
      if (!error) lookUp();
    });
  }

  const LinkConfig config_;
  const Clock& clock_;
  LinkState state_;
  std::shared_ptr<asio::io_context> io_ = std::make_shared<asio::io_context>(1);
  asio::executor_work_guard<asio::io_context::executor_type> work_{
      io_->get_executor()};  // while a lookup goes on
  asio::steady_timer reconnect_timer_{*io_};
  std::shared_ptr<Connection> connection_;
  std::vector<std::string> addresses_;
  std::size_t next_address_ = 0;
  std::thread thread_;
};

ServerLink::ServerLink(const LinkConfig& config, const Clock& clock)
    : impl_(std::make_unique<Impl>(config, clock)) {}
ServerLink::~ServerLink() = default;

SessionConfig ServerLink::waitForSession(std::int64_t timeout_ns) {
  return impl_->state().waitForSession(timeout_ns);
}
std::optional<SessionConfig> ServerLink::session() const {
  return impl_->state().session();
}
std::optional<ReceivedPacket> ServerLink::newest() const {
  return impl_->state().newest();
}
std::optional<ReceivedPacket> ServerLink::atTick(std::uint64_t tick) const {
  return impl_->state().atTick(tick);
}
void ServerLink::keepFirstFrom(const std::vector<std::uint64_t>& ticks) {
  impl_->state().keepFirstFrom(ticks);
}
std::optional<ReceivedPacket> ServerLink::firstFrom(std::uint64_t tick) const {
  return impl_->state().firstFrom(tick);
}
bool ServerLink::waitForTick(std::uint64_t tick, std::int64_t timeout_ns) const {
  return impl_->state().waitForTick(tick, timeout_ns);
}
void ServerLink::requestMode(Mode mode) {
  impl_->request(ModeRequest{mode});
}
void ServerLink::reportFrame(const FrameReport& frame) {
  impl_->state().reportFrame(frame);
}
std::optional<ServerTime> ServerLink::toServer(ClientTime t) const {
  return impl_->state().toServer(t);
}
LinkStats ServerLink::stats() const {
  return impl_->state().stats();
}

}  // namespace coherency
