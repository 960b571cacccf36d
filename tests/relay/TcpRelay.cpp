#include "tests/relay/TcpRelay.h"

#include <chrono>
#include <deque>
#include <functional>
#include <set>
#include <stdexcept>
#include <vector>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>

namespace coherency {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::size_t kReadAtOnce = 64 * 1024;
constexpr std::size_t kMostWaitingBytes = 1024 * 1024;  // then reading stops until some have gone

tcp::endpoint tcpEndpoint(const Endpoint& endpoint) {
  return {asio::ip::make_address(endpoint.host), endpoint.port};
}

struct Shared {
  const Clock& clock;
  std::int64_t delay_ns;
  TcpRelayStats stats;
};

/// A client and its connection to the server. Keeps itself alive through the handlers it waits in, which do
/// nothing after close().
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  using OnEnd = std::function<void(const std::shared_ptr<Connection>&)>;

  Connection(tcp::socket client, asio::io_context& io, Shared& shared, OnEnd on_end)
      : shared_(shared),
        on_end_(std::move(on_end)),
        sides_{std::move(client), tcp::socket(io)},
        pipes_{Pipe(io), Pipe(io)} {}

  void start(const tcp::endpoint& server) {
    sides_[1].async_connect(server, [self = shared_from_this()](const error_code& error) {
      if (self->closed_) return;
      if (error) {
        ++self->shared_.stats.refused;
        return self->reset();
      }
      error_code ignored;
      for (tcp::socket& side : self->sides_) side.set_option(tcp::no_delay(true), ignored);
      for (const std::size_t way : {0U, 1U}) self->read(way);
    });
  }

  void reset() {
    error_code ignored;
    for (tcp::socket& side : sides_)
      side.set_option(asio::socket_base::linger(true, 0), ignored);  // closing then sends a reset
    close();
  }

 private:
  struct Chunk {
    std::int64_t due_ns;
    std::vector<std::byte> bytes;  // none: the end of the stream
  };
  struct Pipe {
    explicit Pipe(asio::io_context& io) : due_timer(io), incoming(kReadAtOnce) {}
    std::deque<Chunk> waiting;
    std::size_t waiting_bytes = 0;
    bool reading = false, writing = false, end_read = false, end_written = false;
    asio::steady_timer due_timer;
    std::vector<std::byte> incoming;
  };

  void read(std::size_t way) {
    Pipe& pipe = pipes_[way];
    if (pipe.reading || pipe.end_read || pipe.waiting_bytes >= kMostWaitingBytes) return;
    pipe.reading = true;
    sides_[way].async_read_some(asio::buffer(pipe.incoming),
                                [self = shared_from_this(), way](const error_code& error, std::size_t size) {
                                  if (!self->closed_) self->arrived(way, error, size);
                                });
  }

  void arrived(std::size_t way, const error_code& error, std::size_t size) {
    if (error && error != asio::error::eof) return reset();
    Pipe& pipe = pipes_[way];
    pipe.reading = false;
    pipe.end_read = error == asio::error::eof;
    const auto begin = pipe.incoming.begin();
    pipe.waiting.push_back(
        {shared_.clock.nowNs() + shared_.delay_ns, {begin, begin + static_cast<std::ptrdiff_t>(size)}});
    pipe.waiting_bytes += size;
    write(way);
    read(way);
  }

  void write(std::size_t way) {
    Pipe& pipe = pipes_[way];
    if (pipe.writing || pipe.waiting.empty()) return;
    pipe.writing = true;
    const std::int64_t due_ns = pipe.waiting.front().due_ns;
    if (due_ns <= shared_.clock.nowNs()) return writeFront(way);
    pipe.due_timer.expires_at(std::chrono::steady_clock::time_point(std::chrono::nanoseconds(due_ns)));
    pipe.due_timer.async_wait([self = shared_from_this(), way](const error_code&) {
      if (!self->closed_) self->writeFront(way);
    });
  }

  void writeFront(std::size_t way) {
    const std::vector<std::byte>& bytes = pipes_[way].waiting.front().bytes;
    if (bytes.empty()) return endOf(way);
    asio::async_write(sides_[1 - way], asio::buffer(bytes),
                      [self = shared_from_this(), way](const error_code& error, std::size_t size) {
                        if (!self->closed_) self->written(way, error, size);
                      });
  }

  void written(std::size_t way, const error_code& error, std::size_t size) {
    if (error) return reset();
    Pipe& pipe = pipes_[way];
    shared_.stats.bytes[way] += size;
    pipe.waiting_bytes -= size;
    pipe.waiting.pop_front();
    pipe.writing = false;
    write(way);
    read(way);
  }

  void endOf(std::size_t way) {
    pipes_[way].end_written = true;
    error_code ignored;
    sides_[1 - way].shutdown(tcp::socket::shutdown_send, ignored);
    if (pipes_[1 - way].end_written) close();
  }

  void close() {
    closed_ = true;
    error_code ignored;
    for (tcp::socket& side : sides_) side.close(ignored);
    for (Pipe& pipe : pipes_) pipe.due_timer.cancel();
    on_end_(shared_from_this());
  }

  Shared& shared_;
  OnEnd on_end_;
  std::array<tcp::socket, 2> sides_;  // client, server
  std::array<Pipe, 2> pipes_;         // up, down: pipe i reads from side i
  bool closed_ = false;
};

}  // namespace

class TcpRelay::Impl {
 public:
  Impl(asio::io_context& io, const Endpoint& listen, const Endpoint& server, std::int64_t delay_ns,
       const Clock& clock)
      : io_(io), server_(tcpEndpoint(server)), acceptor_(io), shared_{clock, delay_ns, {}} {
    try {
      const tcp::endpoint endpoint = tcpEndpoint(listen);
      acceptor_.open(endpoint.protocol());
      acceptor_.set_option(tcp::acceptor::reuse_address(true));
      acceptor_.bind(endpoint);
      acceptor_.listen();
    } catch (const boost::system::system_error& e) {
      throw std::runtime_error("TCP " + describe(listen) + ": " + e.code().message());
    }
    accept();
  }

  void cut() {
    shared_.stats.cut += connections_.size();
    for (const auto cut = connections_; const auto& connection : cut) connection->reset();
  }

  Shared& shared() { return shared_; }

 private:
  void accept() {
    acceptor_.async_accept([this](const error_code& error, tcp::socket client) {
      if (error == asio::error::connection_aborted) return accept();
      if (error) throw std::runtime_error("TCP: cannot accept: " + error.message());
      if (connections_.size() < kMostConnections)
        connect(std::move(client));
      else
        ++shared_.stats.refused;  // it closes with the handler
      accept();
    });
  }

  void connect(tcp::socket client) {
    ++shared_.stats.connections;
    const auto connection = std::make_shared<Connection>(
        std::move(client), io_, shared_,
        [this](const std::shared_ptr<Connection>& ended) { connections_.erase(ended); });
    connections_.insert(connection);
    connection->start(server_);
  }

  asio::io_context& io_;
  tcp::endpoint server_;
  tcp::acceptor acceptor_;
  std::set<std::shared_ptr<Connection>> connections_;
  Shared shared_;
};

TcpRelay::TcpRelay(asio::io_context& io, const Endpoint& listen, const Endpoint& server,
                   std::int64_t delay_ns, const Clock& clock)
    : impl_(std::make_unique<Impl>(io, listen, server, delay_ns, clock)) {}
TcpRelay::~TcpRelay() = default;
void TcpRelay::change(std::int64_t delay_ns) {
  impl_->shared().delay_ns = delay_ns;
}
void TcpRelay::cut() {
  impl_->cut();
}
const TcpRelayStats& TcpRelay::stats() const {
  return impl_->shared().stats;
}

}  // namespace coherency
