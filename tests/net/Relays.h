#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>

namespace coherency::testing {

namespace asio = boost::asio;

/// Stands between a client and a server as a firewall does: at an address of its own, 127.0.0.2, it passes
/// TCP on from the first, and UDP, on the server's own port, from passUdp() on.
class Relay {
 public:
  explicit Relay(std::uint16_t server_port)
      : server_port_(server_port), acceptor_(io_, {at(kAddress), 0}), outside_(io_), inside_(io_) {
    accept();
    thread_ = std::thread([this] { io_.run(); });
  }
  ~Relay() {
    io_.stop();
    thread_.join();
  }

  static constexpr const char* kAddress = "127.0.0.2";
  std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

  void passUdp() {
    asio::post(io_, [this] {
      outside_ = asio::ip::udp::socket(io_, {at(kAddress), server_port_});
      inside_ = asio::ip::udp::socket(io_, {at(kAddress), 0});
      inside_.connect({at("127.0.0.1"), server_port_});
      inward();
      outward();
    });
  }
  void blockUdp() {
    asio::post(io_, [this] {
      outside_.close();
      inside_.close();
    });
  }

 private:
  static asio::ip::address at(const char* address) { return asio::ip::make_address(address); }

  struct Pipe {
    explicit Pipe(asio::io_context& io) : client(io), server(io) {}
    asio::ip::tcp::socket client, server;
    std::array<std::byte, 4096> up{}, down{};
  };
  using PipePtr = std::shared_ptr<Pipe>;

  void accept() {
    const auto pipe = std::make_shared<Pipe>(io_);
    acceptor_.async_accept(pipe->client, [this, pipe](const boost::system::error_code& error) {
      if (error) return;
      pipe->server.connect({at("127.0.0.1"), server_port_});
      pass(pipe, pipe->client, pipe->server, pipe->up);
      pass(pipe, pipe->server, pipe->client, pipe->down);
      accept();
    });
  }

  void pass(const PipePtr& pipe, asio::ip::tcp::socket& from, asio::ip::tcp::socket& to,
            std::array<std::byte, 4096>& bytes) {
    from.async_read_some(asio::buffer(bytes), [this, pipe, &from, &to, &bytes](auto error, std::size_t size) {
      if (!error) asio::write(to, asio::buffer(bytes, size), error);
      if (!error) return pass(pipe, from, to, bytes);
      pipe->client.close(error);
      pipe->server.close(error);
    });
  }

  void inward() {
    outside_.async_receive_from(asio::buffer(up_), client_, [this](auto error, std::size_t size) {
      if (!outside_.is_open()) return;
      if (!error) inside_.send(asio::buffer(up_, size), 0, error);
      inward();
    });
  }
  void outward() {
    inside_.async_receive(asio::buffer(down_), [this](auto error, std::size_t size) {
      if (!inside_.is_open()) return;
      if (!error) outside_.send_to(asio::buffer(down_, size), client_, 0, error);
      outward();
    });
  }

  std::uint16_t server_port_;
  asio::io_context io_{1};
  asio::ip::tcp::acceptor acceptor_;
  asio::ip::udp::socket outside_, inside_;
  asio::ip::udp::endpoint client_;
  std::array<std::byte, 4096> up_{}, down_{};
  std::thread thread_;
};

/// Whether this machine's loopback carries a group's datagrams to who joined it.
inline bool multicastOnLoopback(const std::string& group) {
  try {
    asio::io_context io;
    asio::ip::udp::socket hears(io, {asio::ip::make_address(group), 0}), says(io, asio::ip::udp::v4());
    const auto loopback = asio::ip::address_v4::loopback();
    hears.set_option(asio::ip::multicast::join_group(asio::ip::make_address_v4(group), loopback));
    says.set_option(asio::ip::multicast::outbound_interface(loopback));
    says.send_to(asio::buffer("here"), {asio::ip::make_address(group), hears.local_endpoint().port()});
    hears.non_blocking(true);
    std::array<char, 16> bytes{};
    for (int i = 0; i < 1000; ++i) {
      boost::system::error_code error;
      if (hears.receive(asio::buffer(bytes), 0, error) > 0) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  } catch (const boost::system::system_error&) {
  }
  return false;
}

}  // namespace coherency::testing
