#include "motion_server/broadcast/Broadcaster.h"

#include <array>
#include <atomic>
#include <cstring>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <netinet/tcp.h>

#include "common/wire/Validity.h"
#include "motion_server/broadcast/KeyframeSource.h"
#include "motion_server/broadcast/MotionSender.h"
#include "motion_server/broadcast/SessionHost.h"

namespace coherency {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using asio::ip::udp;
using boost::system::error_code;

constexpr auto kSweepEvery = std::chrono::milliseconds(50);
constexpr auto kAcceptAgain = std::chrono::milliseconds(100);
constexpr std::size_t kMaxOutgoing = 256 * 1024;  ///< control bytes a client may leave unread
constexpr int kMaxUnsent = 2048;                  ///< bytes that the system holds of one connection
constexpr int kDatagramsAtOnce = 64;              ///< then the connections have their turn

std::string place(const std::string& address, std::uint16_t port) {
  const bool v6 = address.find(':') != std::string::npos;
  return (v6 ? "[" + address + "]" : address) + ":" + std::to_string(port);
}

[[noreturn]] void refuse(const BroadcastConfig& config, const char* protocol, const error_code& error) {
  throw std::runtime_error("cannot listen on " + place(config.address, config.port) + " (" + protocol +
                           "): " + error.message() +
                           "; give an address of this machine and a free port, or stop what uses it");
}

/// TCP and UDP on the same port. Where any will do, TCP finds one and UDP must get it too.
struct Ports {
  explicit Ports(asio::io_context& io) : tcp_acceptor(io), udp_socket(io) {}

  void bind(const BroadcastConfig& config) {
    error_code error;
    const auto address = asio::ip::make_address(config.address, error);
    if (error) refuse(config, "address", error);
    for (int attempts = config.port == 0 ? 16 : 1; attempts > 0; --attempts) {
      if (const error_code tcp_error = bindTcp({address, config.port})) refuse(config, "TCP", tcp_error);
      error = bindUdp({address, tcp_acceptor.local_endpoint().port()});
      if (!error) return;
    }
    refuse(config, "UDP", error);
  }

  error_code bindTcp(const tcp::endpoint& at) {
    error_code error;
    tcp_acceptor = tcp::acceptor(tcp_acceptor.get_executor());
    if (tcp_acceptor.open(at.protocol(), error)) return error;
    if (tcp_acceptor.set_option(tcp::acceptor::reuse_address(true), error)) return error;
    if (at.address().is_v6()) tcp_acceptor.set_option(asio::ip::v6_only(false), error);
    if (tcp_acceptor.bind(at, error)) return error;
    tcp_acceptor.listen(asio::socket_base::max_listen_connections, error);
    return error;
  }

  error_code bindUdp(const udp::endpoint& at) {
    error_code error;
    udp_socket = udp::socket(udp_socket.get_executor());
    if (udp_socket.open(at.protocol(), error)) return error;
    if (at.address().is_v6()) udp_socket.set_option(asio::ip::v6_only(false), error);
    if (udp_socket.bind(at, error)) return error;
    udp_socket.non_blocking(true, error);
    return error;
  }

  tcp::acceptor tcp_acceptor;
  udp::socket udp_socket;
};

/// Sending to a group needs to be told through which interface; one that the address to listen on names.
void sendToGroups(udp::socket& socket, const asio::ip::address& from) {
  error_code ignored;  // what cannot be set makes the group silent, and clients that do not hear it say so
  socket.set_option(asio::ip::multicast::hops(1), ignored);
  socket.set_option(asio::ip::multicast::enable_loopback(true), ignored);
  if (from.is_v4() && !from.is_unspecified())
    socket.set_option(asio::ip::multicast::outbound_interface(from.to_v4()), ignored);
}

/// So that motion over TCP waits here, where a newer packet takes its place, and not in the system's buffers.
void keepBacklogShort(tcp::socket& socket) {
  const int unsent = kMaxUnsent;
  ::setsockopt(socket.native_handle(), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &unsent, sizeof unsent);
}

UdpAddress opaque(const udp::endpoint& endpoint) {
  UdpAddress address;
  address.size = endpoint.size();
  std::memcpy(address.bytes.data(), endpoint.data(), endpoint.size());
  return address;
}

/// One client's control connection: what goes out waits here while an earlier piece is being written.
struct Connection {
  explicit Connection(tcp::socket accepted) : socket(std::move(accepted)) {}
  tcp::socket socket;
  std::uint32_t id = 0;
  std::array<std::byte, 4096> incoming{};
  std::vector<std::byte> writing;
  std::vector<std::byte> waiting;
  bool ends = false;  ///< nothing follows what is queued
};
using ConnectionPtr = std::shared_ptr<Connection>;

BroadcastConfig checked(const BroadcastConfig& config) {
  if (config.redundancy < 0 || config.redundancy > static_cast<int>(kMaxPrevious)) {
    throw std::invalid_argument("redundancy " + std::to_string(config.redundancy) + " is not within 0 to " +
                                std::to_string(kMaxPrevious));
  }
  if (config.max_clients < 1 || config.silence_ns <= 0) {
    throw std::invalid_argument("max_clients and silence must be positive");
  }
  return config;
}

}  // namespace

class Broadcaster::Impl {
 public:
  Impl(const BroadcastConfig& config, SessionConfig session, const Clock& clock)
      : clock_(clock), ports_(io_) {
    checked(config);
    ports_.bind(config);
    session.udp_port = port_ = ports_.tcp_acceptor.local_endpoint().port();
    session.session_id = session.client_id = 1;  // drawn by the host; any will do for the check
    if (!isValid(session)) throw std::invalid_argument("scene, rig or period of the session is out of range");
    host_ = std::make_unique<SessionHost>(config, session, randomKey);
    MotionSenderConfig sending{session.form, host_->motionKey(), config.redundancy, {}};
    if (session.multicast) {
      sendToGroups(ports_.udp_socket, asio::ip::make_address(config.address));
      sending.group =
          opaque(udp::endpoint(asio::ip::make_address(session.multicast->address), session.multicast->port));
    }
    sender_ = std::make_unique<MotionSender>(sending, ports_.udp_socket.native_handle(), keyframes_);
    accept();
    awaitDatagrams();
    sweep();
    thread_ = std::thread([this] { io_.run(); });
  }

  ~Impl() {
    io_.stop();
    thread_.join();
    for (const auto& [id, connection] : connections_) {
      if (!connection->writing.empty() || connection->ends) continue;
      const auto goodbye = host_->tell(id, Goodbye{"the server ends", GoodbyeCause::Leaving});
      error_code ignored;
      connection->socket.non_blocking(true, ignored);
      connection->socket.write_some(asio::buffer(goodbye), ignored);
    }
  }

  void publish(const WorldState& world, const MotionSample& sample, const std::optional<FrameState>& frame) {
    const bool tunnels = sender_->publish(world, sample, frame);
    if (tunnels && !tunnelling_.exchange(true)) asio::post(io_, [this] { tunnel(); });
  }
  std::uint16_t port() const { return port_; }
  std::optional<Mode> takeModeRequest() {
    const int mode = requested_mode_.exchange(kNoMode);
    return mode == kNoMode ? std::nullopt : std::optional(static_cast<Mode>(mode));
  }

  std::vector<FrameReport> takeReports() {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    return lock ? host_->takeReports() : std::vector<FrameReport>();
  }

  template <class Ask>
  auto withHost(Ask ask) {
    const std::lock_guard lock(mutex_);
    return ask(*host_);
  }

 private:
  ServerTime now() const { return {clock_.nowNs()}; }

  void accept() {
    ports_.tcp_acceptor.async_accept([this](const error_code& error, tcp::socket socket) {
      if (error) {  // out of descriptors, as a rule: others go on, and this passes
        accept_timer_.expires_after(kAcceptAgain);
        accept_timer_.async_wait([this](const error_code&) { accept(); });
        return;
      }
      admit(std::move(socket));
      accept();
    });
  }

  void admit(tcp::socket socket) {
    error_code error;
    const auto remote = socket.remote_endpoint(error);
    if (error) return;
    socket.set_option(tcp::no_delay(true), error);
    keepBacklogShort(socket);
    auto connection = std::make_shared<Connection>(std::move(socket));
    std::optional<std::uint32_t> surplus;
    {
      const std::lock_guard lock(mutex_);
      connection->id = host_->open(place(remote.address().to_string(), remote.port()), now());
      surplus = host_->surplus();
    }
    connections_[connection->id] = connection;
    read(connection);
    if (surplus) drop(*surplus);
  }

  void read(const ConnectionPtr& connection) {
    connection->socket.async_read_some(asio::buffer(connection->incoming),
                                       [this, connection](const error_code& error, std::size_t size) {
                                         // Swept away while this read was waiting its turn: nothing is left
                                         // to heed.
                                         if (error || !connection->socket.is_open())
                                           return drop(connection->id);
                                         onBytes(connection, size);
                                         if (connection->socket.is_open()) read(connection);
                                       });
  }

  void onBytes(const ConnectionPtr& connection, std::size_t size) {
    if (connection->ends) return;  // read on to let the goodbye arrive, but heed nothing
    SessionHost::Reaction reaction;
    {
      const std::lock_guard lock(mutex_);
      reaction = host_->receive(connection->id, std::span(connection->incoming).first(size), now());
      refreshTargets();
    }
    if (reaction.mode) requested_mode_.store(static_cast<int>(*reaction.mode));
    connection->ends = reaction.goodbye;
    send(connection, reaction.send);
    if (reaction.wants_keyframes) sayKeyframes(connection);
  }

  void send(const ConnectionPtr& connection, const std::vector<std::byte>& bytes) {
    connection->waiting.insert(connection->waiting.end(), bytes.begin(), bytes.end());
    if (connection->waiting.size() > kMaxOutgoing) return drop(connection->id);
    write(connection);
  }

  void tell(const ConnectionPtr& connection, const ControlMessage& message) {
    send(connection, withHost([&](SessionHost& host) { return host.tell(connection->id, message); }));
  }

  void sayKeyframes(const ConnectionPtr& connection) {
    for (const Keyframe& keyframe : keyframes_.needed()) tell(connection, keyframe);
  }

  /// A keyframe that is new goes to everybody.
  void tendKeyframes() {
    keyframes_.allHave(withHost([](SessionHost& host) { return host.keyframeOfAll(); }));
    const std::uint32_t newest = keyframes_.newest();
    if (newest == said_keyframe_) return;
    said_keyframe_ = newest;
    for (const std::uint32_t id : withHost([](SessionHost& host) { return host.welcomedClients(); }))
      if (const auto found = connections_.find(id); found != connections_.end()) sayKeyframes(found->second);
  }

  /// The newest motion, to those whose way it is and who have taken what came before: nothing queues.
  void tunnel() {
    tunnelling_.store(false);
    const Tunnelled motion{sender_->newestBody()};
    const auto ids = withHost([](SessionHost& host) { return host.tunnels(); });
    for (const std::uint32_t id : ids) {
      const auto found = connections_.find(id);
      if (found == connections_.end()) continue;
      const bool idle = found->second->writing.empty() && found->second->waiting.empty();
      withHost([&](SessionHost& host) { return host.countTunnelled(id, idle), 0; });
      if (idle) tell(found->second, motion);
    }
  }

  void write(const ConnectionPtr& connection) {
    if (!connection->writing.empty()) return;
    if (connection->waiting.empty()) {
      error_code ignored;
      if (connection->ends) connection->socket.shutdown(tcp::socket::shutdown_send, ignored);
      return;
    }
    connection->writing.swap(connection->waiting);
    asio::async_write(connection->socket, asio::buffer(connection->writing),
                      [this, connection](const error_code& error, std::size_t) {
                        connection->writing.clear();
                        if (error) return drop(connection->id);
                        write(connection);
                      });
  }

  void drop(std::uint32_t id) {
    const auto found = connections_.find(id);
    if (found == connections_.end()) return;
    error_code ignored;
    found->second->socket.close(ignored);
    connections_.erase(found);
    const std::lock_guard lock(mutex_);
    host_->close(id);
    refreshTargets();
  }

  void sweep() {
    for (const std::uint32_t id : withHost([this](SessionHost& host) { return host.expired(now()); }))
      drop(id);
    tendKeyframes();
    sweep_timer_.expires_after(kSweepEvery);
    sweep_timer_.async_wait([this](const error_code&) { sweep(); });
  }

  void awaitDatagrams() {
    ports_.udp_socket.async_wait(udp::socket::wait_read, [this](const error_code&) {
      receiveDatagrams();
      awaitDatagrams();
    });
  }

  void receiveDatagrams() {
    std::array<std::byte, 2 * kMaxDatagram> bytes;  // so that too long a datagram is seen to be
    for (int i = 0; i < kDatagramsAtOnce; ++i) {
      udp::endpoint from;
      error_code error;
      const std::size_t size = ports_.udp_socket.receive_from(asio::buffer(bytes), from, 0, error);
      if (error == asio::error::would_block) return;
      if (!error) onDatagram(std::span(bytes).first(size), from);  // an error is a news of one client's port
    }
  }

  void onDatagram(std::span<std::byte> bytes, const udp::endpoint& from) {
    const ServerTime arrived = now();
    {
      const std::lock_guard lock(mutex_);
      auto answer = host_->datagram(bytes, opaque(from), arrived);
      refreshTargets();
      if (!answer) return;
      answer->reply.t2_server_ns = now().ns;
      host_->encode(*answer, reply_bytes_);
    }
    error_code ignored;
    ports_.udp_socket.send_to(asio::buffer(reply_bytes_), from, 0, ignored);
  }

  /// Under mutex_.
  void refreshTargets() {
    if (host_->targetsVersion() == targets_version_) return;
    targets_version_ = host_->targetsVersion();
    sender_->setTargets(host_->targets());
  }

  const Clock& clock_;
  asio::io_context io_{1};
  Ports ports_;
  asio::steady_timer accept_timer_{io_};
  asio::steady_timer sweep_timer_{io_};
  std::uint16_t port_ = 0;
  std::map<std::uint32_t, ConnectionPtr> connections_;
  std::vector<std::byte> reply_bytes_;
  std::uint64_t targets_version_ = 0;
  std::uint32_t said_keyframe_ = 0;
  KeyframeSource keyframes_;
  std::atomic<bool> tunnelling_{false};  // the socket thread has been asked to, and has not begun
  static constexpr int kNoMode = -1;
  std::atomic<int> requested_mode_{kNoMode};  // a Mode, from the socket thread to the sampling thread
  std::mutex mutex_;                          // guards host_; publish() does not need it
  std::unique_ptr<SessionHost> host_;
  std::unique_ptr<MotionSender> sender_;
  std::thread thread_;
};

Broadcaster::Broadcaster(const BroadcastConfig& config, const SessionConfig& session, const Clock& clock)
    : impl_(std::make_unique<Impl>(config, session, clock)) {}
Broadcaster::~Broadcaster() = default;

void Broadcaster::publish(const WorldState& world, const MotionSample& sample,
                          const std::optional<FrameState>& frame) {
  impl_->publish(world, sample, frame);
}
std::vector<std::string> Broadcaster::takeRefusals() {
  return impl_->withHost([](SessionHost& host) { return host.takeRefusals(); });
}
std::vector<FrameReport> Broadcaster::takeReports() {
  return impl_->takeReports();
}
std::optional<Mode> Broadcaster::takeModeRequest() {
  return impl_->takeModeRequest();
}
std::uint16_t Broadcaster::port() const {
  return impl_->port();
}
std::vector<ClientStatus> Broadcaster::clients() const {
  return impl_->withHost([](const SessionHost& host) { return host.clients(); });
}
std::size_t Broadcaster::present() const {
  return impl_->withHost([](const SessionHost& host) { return host.welcomedClients().size(); });
}
std::uint64_t Broadcaster::served() const {
  return impl_->withHost([](const SessionHost& host) { return host.served(); });
}
RejectCounts Broadcaster::rejected() const {
  return impl_->withHost([](const SessionHost& host) { return host.rejected(); });
}
StereoStatus Broadcaster::stereo() const {
  return impl_->withHost([](const SessionHost& host) { return host.stereo(); });
}

}  // namespace coherency
