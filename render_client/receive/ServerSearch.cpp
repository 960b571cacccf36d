#include "render_client/receive/ServerSearch.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <memory>
#include <set>
#include <stdexcept>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

namespace coherency {

namespace asio = boost::asio;
using asio::ip::udp;
using boost::system::error_code;

namespace {

constexpr auto kAskEvery = std::chrono::milliseconds(200);

std::uint32_t bitsOf(const sockaddr* address) {
  return ntohl(reinterpret_cast<const sockaddr_in*>(address)->sin_addr.s_addr);
}

/// Where to ask: the last address of each network, whether or not the interface was told that it is its
/// broadcast address, and of the loopback network, whose interface does not broadcast.
std::set<asio::ip::address_v4> broadcastAddresses() {
  std::set<asio::ip::address_v4> found{asio::ip::make_address_v4("127.255.255.255")};
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) != 0)
    throw std::runtime_error("cannot list this machine's networks: " + std::string(std::strerror(errno)));
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> interfaces(first, ::freeifaddrs);
  for (const ifaddrs* i = interfaces.get(); i != nullptr; i = i->ifa_next)
    if (i->ifa_addr != nullptr && i->ifa_addr->sa_family == AF_INET && (i->ifa_flags & IFF_UP) != 0 &&
        (i->ifa_flags & IFF_BROADCAST) != 0 && i->ifa_netmask != nullptr)
      found.insert(asio::ip::address_v4(bitsOf(i->ifa_addr) | ~bitsOf(i->ifa_netmask)));
  return found;
}

class SearchParty {
 public:
  SearchParty() : socket_(io_, udp::v4()), timer_(io_) {
    socket_.set_option(udp::socket::broadcast(true));
    socket_.bind({asio::ip::address_v4::any(), 0});
    ask();
    receive();
  }

  std::vector<FoundServer> listen(std::int64_t listen_ns) {
    io_.run_for(std::chrono::nanoseconds(listen_ns));
    return found_;
  }

 private:
  void ask() {
    error_code ignored;  // a network that is down has no servers
    for (const auto& address : addresses_)
      socket_.send_to(asio::buffer(question_), {address, kDiscoveryPort}, 0, ignored);
    timer_.expires_after(kAskEvery);
    timer_.async_wait([this](const error_code& error) {
      if (!error) ask();
    });
  }

  void receive() {
    socket_.async_receive_from(asio::buffer(bytes_), from_,
                               [this](const error_code& error, std::size_t size) {
                                 if (!error) note(decodeDiscovery(std::span(bytes_).first(size)));
                                 receive();
                               });
  }

  void note(const std::variant<Reject, Search, Announcement>& answer) {
    const auto* const announcement = std::get_if<Announcement>(&answer);
    if (announcement == nullptr) return;
    const std::string address = from_.address().to_string();
    const bool known = std::any_of(found_.begin(), found_.end(), [&](const FoundServer& server) {
      return server.address == address && server.announcement.port == announcement->port;
    });
    if (!known) found_.push_back({address, *announcement});
  }

  const std::set<asio::ip::address_v4> addresses_ = broadcastAddresses();
  const std::vector<std::byte> question_ = encodeDiscovery(Search{});
  asio::io_context io_{1};
  udp::socket socket_;
  asio::steady_timer timer_;
  udp::endpoint from_;
  std::array<std::byte, 2 * kMaxDatagram> bytes_{};
  std::vector<FoundServer> found_;
};

}  // namespace

std::vector<FoundServer> searchServers(std::int64_t listen_ns) {
  try {
    return SearchParty().listen(listen_ns);
  } catch (const boost::system::system_error& e) {
    throw std::runtime_error(std::string("cannot search for servers: ") + e.what());
  }
}

std::string describe(const FoundServer& server) {
  const Announcement& a = server.announcement;
  const std::string place = server.address + ":" + std::to_string(a.port);
  const std::string version =
      a.major == kWireMajor ? ""
                            : ", of another version (" + std::to_string(a.major) + "): not for this client";
  return place + "  " + (a.host.empty() ? "unnamed" : a.host) + "  scene " + a.scene + ", " +
         std::to_string(a.clients) + " clients, " + (a.keyed ? "with a key" : "without a key") + version;
}

}  // namespace coherency
