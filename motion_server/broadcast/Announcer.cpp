#include "motion_server/broadcast/Announcer.h"

#include <array>
#include <stdexcept>
#include <thread>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include "common/sync/Clock.h"
#include "motion_server/broadcast/MessageBudget.h"

namespace coherency {

namespace asio = boost::asio;
using asio::ip::udp;
using boost::system::error_code;

namespace {

constexpr std::int64_t kAnswersPerSecond = 50;
constexpr std::int64_t kAnswersAtOnce = 100;

}  // namespace

class Announcer::Impl {
 public:
  Impl(const std::string& address, std::function<Announcement()> say)
      : say_(std::move(say)),
        loopback_only_(asio::ip::make_address(address).is_loopback()),
        budget_(kAnswersPerSecond, kAnswersAtOnce, {clock_.nowNs()}),
        socket_(io_) {
    error_code error;
    if (!socket_.open(udp::v4(), error)) {
      socket_.set_option(udp::socket::reuse_address(true), error);
      socket_.bind({asio::ip::address_v4::any(), kDiscoveryPort}, error);
    }
    if (error)
      throw std::runtime_error("cannot answer searches on UDP port " + std::to_string(kDiscoveryPort) + ": " +
                               error.message());
    receive();
    thread_ = std::thread([this] { io_.run(); });
  }

  ~Impl() {
    io_.stop();
    thread_.join();
  }

 private:
  void receive() {
    socket_.async_receive_from(asio::buffer(bytes_), from_,
                               [this](const error_code& error, std::size_t size) {
                                 if (!error) answer(std::span(bytes_).first(size));
                                 receive();
                               });
  }

  /// What is no search is none of ours to count: others may use this port, too.
  void answer(std::span<const std::byte> datagram) {
    if (loopback_only_ && !from_.address().is_loopback()) return;
    if (!std::holds_alternative<Search>(decodeDiscovery(datagram)) || !budget_.take({clock_.nowNs()})) return;
    error_code ignored;
    socket_.send_to(asio::buffer(encodeDiscovery(say_())), from_, 0, ignored);
  }

  std::function<Announcement()> say_;
  bool loopback_only_;
  MonotonicClock clock_;
  MessageBudget budget_;
  asio::io_context io_{1};
  udp::socket socket_;
  udp::endpoint from_;
  std::array<std::byte, 2 * kMaxDatagram> bytes_{};
  std::thread thread_;
};

Announcer::Announcer(const std::string& address, std::function<Announcement()> say)
    : impl_(std::make_unique<Impl>(address, std::move(say))) {}
Announcer::~Announcer() = default;

}  // namespace coherency
