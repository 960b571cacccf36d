#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <thread>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <gtest/gtest.h>

#include "common/sync/Clock.h"
#include "motion_server/broadcast/Announcer.h"
#include "render_client/receive/ServerSearch.h"

// On the port that all servers answer on: others on this machine may answer, too, and are passed over.

namespace coherency {
namespace {

namespace asio = boost::asio;
using asio::ip::udp;

constexpr std::int64_t kListenNs = 500'000'000;

/// A server of this test run, by a port that none really listens on.
std::unique_ptr<Announcer> announce(const std::string& scene, std::uint16_t port, bool keyed = false,
                                    const std::string& address = "127.0.0.1") {
  Announcement what;
  what.host = "test-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed());
  what.scene = scene;
  what.port = port;
  what.keyed = keyed;
  what.clients = 2;
  return std::make_unique<Announcer>(address, [what] { return what; });
}

std::vector<FoundServer> foundAt(std::uint16_t port, const std::string& address = "127.0.0.1") {
  std::vector<FoundServer> found = searchServers(kListenNs);
  std::erase_if(found, [&](const FoundServer& server) {
    return server.announcement.port != port || server.address != address;
  });
  return found;
}

class DiscoveryTest : public ::testing::Test {
 protected:
  DiscoveryTest() : socket_(io_, {asio::ip::make_address("127.0.0.1"), 0}) {
    socket_.set_option(udp::socket::broadcast(true));
    socket_.non_blocking(true);
  }
  void say(const std::vector<std::byte>& datagram) {
    const auto everybody = asio::ip::make_address("127.255.255.255");
    socket_.send_to(asio::buffer(datagram), {everybody, kDiscoveryPort});
  }
  /// How many answers name this port, of those that come before an answer to a search said now.
  int answersAt(std::uint16_t port, bool search_at_the_end = true) {
    if (search_at_the_end) say(encodeDiscovery(Search{}));
    int answers = 0;
    const std::int64_t until_ns = clock_.nowNs() + kListenNs;
    while (clock_.nowNs() < until_ns) {
      std::array<std::byte, 2000> bytes{};
      boost::system::error_code error;
      const std::size_t size = socket_.receive(asio::buffer(bytes), 0, error);
      if (error) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        continue;
      }
      EXPECT_LE(size, kSearchSize) << "an answer is no longer than what it answers";
      const auto decoded = decodeDiscovery(std::span(bytes).first(size));
      const auto* const answer = std::get_if<Announcement>(&decoded);
      answers += answer != nullptr && answer->port == port ? 1 : 0;
    }
    return answers;
  }

  MonotonicClock clock_;
  asio::io_context io_;
  udp::socket socket_;
};

TEST_F(DiscoveryTest, TwoServersOnOneMachineAreBothFoundOnce) {
  const auto first = announce("laboratory", 61'001);
  const auto second = announce("corridor", 61'002, true);
  const std::vector<FoundServer> all = searchServers(kListenNs);
  const auto at = [&](std::uint16_t port) {
    return std::count_if(all.begin(), all.end(), [&](const FoundServer& server) {
      return server.announcement.port == port && server.address == "127.0.0.1";
    });
  };
  EXPECT_EQ(at(61'001), 1) << "however often they were asked";
  EXPECT_EQ(at(61'002), 1);
  for (const FoundServer& server : all) {
    if (server.announcement.port != 61'002) continue;
    EXPECT_EQ(server.announcement.scene, "corridor");
    EXPECT_TRUE(server.announcement.keyed);
    EXPECT_EQ(server.announcement.clients, 2U);
    const std::string line = describe(server);
    for (const char* part : {"127.0.0.1:61002", "scene corridor", "2 clients", "with a key"})
      EXPECT_NE(line.find(part), std::string::npos) << line;
  }
}

TEST_F(DiscoveryTest, AServerOnLoopbackAnswersLoopbackAlone) {
  const auto server = announce("laboratory", 61'003);
  EXPECT_EQ(foundAt(61'003).size(), 1U);
  const std::vector<FoundServer> all = searchServers(kListenNs);
  for (const FoundServer& found : all) {
    if (found.announcement.port != 61'003) continue;
    EXPECT_EQ(found.address.rfind("127.", 0), 0U) << found.address;
  }
}

TEST_F(DiscoveryTest, AServerForAllAnswersLoopbackToo) {
  const auto server = announce("laboratory", 61'004, false, "0.0.0.0");
  EXPECT_EQ(foundAt(61'004).size(), 1U);
}

TEST_F(DiscoveryTest, WhoHasEndedIsNotFound) {
  announce("laboratory", 61'005);
  EXPECT_TRUE(foundAt(61'005).empty());
}

TEST_F(DiscoveryTest, WhatIsNoSearchIsNotAnswered) {
  const auto server = announce("laboratory", 61'006);
  say(std::vector<std::byte>(700, std::byte{0x55}));
  say(std::vector<std::byte>(1, std::byte{0}));
  Announcement posing;
  posing.scene = "laboratory";
  posing.port = 61'007;
  say(encodeDiscovery(posing));
  auto brief = encodeDiscovery(Search{});
  brief.resize(20);  // would be answered with more than was asked
  say(brief);
  EXPECT_EQ(answersAt(61'006), 1) << "but for the search said at the end";
}

TEST_F(DiscoveryTest, WhoSearchesWithoutEndIsAnsweredWithinBounds) {
  const auto server = announce("laboratory", 61'008);
  const auto search = encodeDiscovery(Search{});
  const std::int64_t begun_ns = clock_.nowNs();
  for (int i = 0; i < 400; ++i) {
    say(search);
    if (i % 20 == 19) std::this_thread::sleep_for(std::chrono::milliseconds(1));  // for what sockets hold
  }
  const int answers = answersAt(61'008, false);
  EXPECT_GT(answers, 0);
  const double passed_s = static_cast<double>(clock_.nowNs() - begun_ns) * 1e-9;
  EXPECT_LE(answers, 101.0 + 50.0 * passed_s) << "a hundred at once, and then fifty a second";
}

}  // namespace
}  // namespace coherency
