#include <array>
#include <atomic>
#include <chrono>
#include <random>
#include <stdexcept>
#include <thread>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <gtest/gtest.h>

#include "motion_server/broadcast/Broadcaster.h"
#include "render_client/receive/ServerLink.h"
#include "tests/net/Support.h"

// Real sockets on loopback. Nothing waits for a fixed time: every wait is for a condition and has a deadline
// that is generous enough for a loaded machine.

namespace coherency {
namespace {

namespace asio = boost::asio;
using namespace testing;
using namespace std::chrono_literals;
using asio::ip::tcp;
using asio::ip::udp;

constexpr std::int64_t kPatienceNs = 10'000'000'000;

template <class Condition>
bool eventually(Condition condition, std::chrono::milliseconds patience = 10s) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

/// A server that publishes numbered samples about once a millisecond.
class Server {
 public:
  explicit Server(const Clock& clock, std::uint16_t port = 0, int max_clients = 64)
      : clock_(clock), broadcaster_(config(port, max_clients), laboratory(), clock) {}
  ~Server() { stop(); }

  void start() {
    thread_ = std::thread([this] {
      while (!stopping_) {
        publish();
        std::this_thread::sleep_for(1ms);
      }
    });
  }
  void stop() {
    stopping_ = true;
    if (thread_.joinable()) thread_.join();
  }
  void publish() {
    MotionSample sample;
    sample.sequence = ++sequence_;
    sample.server_time_ns = clock_.nowNs();
    WorldState world;
    world.tick = sample.sequence;
    mode_ = broadcaster_.takeModeRequest().value_or(mode_);
    world.mode = mode_;
    broadcaster_.publish(world, sample);
  }

  Broadcaster& broadcaster() { return broadcaster_; }
  std::uint16_t port() const { return broadcaster_.port(); }
  std::size_t connected() const {
    std::size_t count = 0;
    for (const ClientStatus& client : broadcaster_.clients()) count += client.connected ? 1 : 0;
    return count;
  }

 private:
  static BroadcastConfig config(std::uint16_t port, int max_clients) {
    BroadcastConfig c;
    c.port = port;
    c.max_clients = max_clients;
    return c;
  }
  const Clock& clock_;
  Broadcaster broadcaster_;
  std::uint64_t sequence_ = 0;
  Mode mode_ = Mode::Operator;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

bool receives(const ServerLink& link) {
  const auto newest = link.newest();
  return link.waitForTick(newest ? newest->packet.world.tick + 1 : 1, kPatienceNs);
}

class Loopback : public ::testing::Test {
 protected:
  LinkConfig link(std::uint16_t port, const std::string& eye = "left",
                  const std::string& host = "127.0.0.1") {
    return {host, port, eye};
  }
  MonotonicClock clock_;
};

TEST_F(Loopback, TwoEyesLoseNothingWhileAThirdComesAndGoes) {
  Server server(clock_);
  ServerLink left(link(server.port(), "left"), clock_);
  ServerLink right(link(server.port(), "right"), clock_);
  EXPECT_EQ(left.waitForSession(kPatienceNs).session_id, right.waitForSession(kPatienceNs).session_id);
  server.start();
  ASSERT_TRUE(receives(left));
  ASSERT_TRUE(receives(right));
  {
    ServerLink third(link(server.port(), "mono"), clock_);
    ASSERT_TRUE(receives(third));
    EXPECT_EQ(server.connected(), 3U);
  }
  EXPECT_TRUE(eventually([&] { return server.connected() == 2; }));
  ASSERT_TRUE(left.waitForTick(2200, 60'000'000'000));
  server.stop();
  ASSERT_TRUE(eventually([&] { return left.newest()->packet.hash == right.newest()->packet.hash; }));
  for (const LinkStats& stats : {left.stats(), right.stats()}) {
    EXPECT_GE(stats.received, 2000U);
    EXPECT_EQ(stats.lost, 0U);
    EXPECT_EQ(stats.reordered, 0U);
    EXPECT_EQ(stats.rejected, 0U);
    EXPECT_EQ(stats.connections, 1U);
    EXPECT_TRUE(stats.clock_known);
    // Both ends read one clock, so that the truth is zero.
    EXPECT_LE(std::abs(stats.clock_offset_ns), stats.clock_bound_ns);
  }
}

TEST_F(Loopback, APacketCarriesTheSamplesBeforeIt) {
  Server server(clock_);
  ServerLink eye(link(server.port()), clock_);
  server.start();
  ASSERT_TRUE(eye.waitForTick(10, kPatienceNs));
  const MotionPacket packet = eye.newest()->packet;
  ASSERT_EQ(packet.previous.size(), 2U);
  EXPECT_EQ(packet.previous[0].sequence, packet.sample.sequence - 1);
  EXPECT_EQ(packet.previous[1].sequence, packet.sample.sequence - 2);
  EXPECT_EQ(packet.hash, stateHash(packet.world, packet.sample));
}

/// The first of the last thousand ticks in robot mode that came to this eye.
std::uint64_t firstRobotTick(const ServerLink& eye) {
  const std::uint64_t newest = eye.newest()->packet.world.tick;
  for (std::uint64_t tick = newest > 900 ? newest - 900 : 1; tick <= newest; ++tick) {
    const auto packet = eye.atTick(tick);
    if (packet && packet->packet.world.mode == Mode::Robot) return tick;
  }
  return 0;
}

TEST_F(Loopback, BothEyesSwitchModesAtTheTickOneOfThemAskedFor) {
  Server server(clock_);
  ServerLink left(link(server.port(), "left"), clock_);
  ServerLink right(link(server.port(), "right"), clock_);
  server.start();
  ASSERT_TRUE(receives(left));
  ASSERT_TRUE(receives(right));
  left.requestMode(Mode::Robot);
  const auto inRobotMode = [](const ServerLink& eye) {
    return eye.newest()->packet.world.mode == Mode::Robot;
  };
  ASSERT_TRUE(eventually([&] { return inRobotMode(left) && inRobotMode(right); }));
  server.stop();
  EXPECT_GT(firstRobotTick(left), 1U);
  EXPECT_EQ(firstRobotTick(left), firstRobotTick(right));
}

TEST_F(Loopback, ARestartedClientReceivesAgainWithinASecond) {
  Server server(clock_);
  server.start();
  auto eye = std::make_unique<ServerLink>(link(server.port()), clock_);
  ASSERT_TRUE(receives(*eye));
  eye.reset();
  const std::int64_t before = clock_.nowNs();
  eye = std::make_unique<ServerLink>(link(server.port()), clock_);
  ASSERT_TRUE(receives(*eye));
  EXPECT_LT(clock_.nowNs() - before, 1'000'000'000);
}

TEST_F(Loopback, AServerThatReturnsIsFoundAgain) {
  auto server = std::make_unique<Server>(clock_);
  const std::uint16_t port = server->port();
  ServerLink left(link(port, "left"), clock_);
  ServerLink right(link(port, "right"), clock_);
  server->start();
  ASSERT_TRUE(receives(left) && receives(right));
  const std::uint64_t first_session = left.session()->session_id;
  server.reset();
  EXPECT_TRUE(eventually([&] { return !left.stats().connected && !right.stats().connected; }));
  EXPECT_TRUE(left.newest());  // the last pose is held
  server = std::make_unique<Server>(clock_, port);
  server->start();
  for (const ServerLink* eye : {&left, &right}) {
    ASSERT_TRUE(eventually([&] { return eye->session()->session_id != first_session && eye->newest(); }));
    EXPECT_EQ(eye->stats().connections, 2U);
    EXPECT_EQ(eye->newest()->packet.session_id, eye->session()->session_id);
  }
}

TEST_F(Loopback, AReportedFrameIsCompared) {
  Server server(clock_);
  ServerLink left(link(server.port(), "left"), clock_);
  ServerLink right(link(server.port(), "right"), clock_);
  left.waitForSession(kPatienceNs);
  right.waitForSession(kPatienceNs);
  left.reportFrame({5, 77, 1000});
  right.reportFrame({5, 77, 1500});
  EXPECT_TRUE(eventually([&] { return server.broadcaster().stereo().frames_agreeing == 1; }));
  EXPECT_EQ(server.broadcaster().stereo().present_skew_ns, std::vector<std::int64_t>{500});
}

std::uint64_t rejectedBy(Server& server) {
  const RejectCounts counts = server.broadcaster().rejected();
  return counts.malformed + counts.oversized + counts.version + counts.foreign;
}

TEST_F(Loopback, RandomBytesAreCountedAndHurtNobody) {
  Server server(clock_);
  server.start();
  ServerLink eye(link(server.port()), clock_);
  ASSERT_TRUE(receives(eye));
  asio::io_context io;
  std::mt19937 random(7);
  udp::socket udp_noise(io, udp::v4());
  const udp::endpoint udp_port(asio::ip::make_address("127.0.0.1"), server.port());
  constexpr std::size_t kNoise = 300;
  for (std::size_t i = 0; i < kNoise; ++i) {
    std::vector<std::uint8_t> bytes(random() % 2000);
    for (auto& b : bytes) b = static_cast<std::uint8_t>(random());
    udp_noise.send_to(asio::buffer(bytes), udp_port);
    // Not more at a time than the server's socket holds.
    if (i % 50 == 0) {
      ASSERT_TRUE(eventually([&] { return rejectedBy(server) >= i; })) << i;
    }
  }
  for (int i = 0; i < 20; ++i) {
    tcp::socket tcp_noise(io);
    tcp_noise.connect({udp_port.address(), server.port()});
    std::array<std::uint8_t, 64> bytes{};  // a length that can be, and then no message
    bytes[3] = 16;
    for (std::size_t b = 4; b < bytes.size(); ++b) bytes[b] = static_cast<std::uint8_t>(random() | 0x80);
    asio::write(tcp_noise, asio::buffer(bytes));
    // The server says why and closes.
    std::vector<std::byte> heard(1000);
    boost::system::error_code error;
    heard.resize(asio::read(tcp_noise, asio::buffer(heard), error));
    EXPECT_TRUE(error);
  }
  EXPECT_TRUE(eventually([&] { return rejectedBy(server) >= kNoise + 20; }));
  EXPECT_GT(server.broadcaster().rejected().oversized, 0U);
  EXPECT_TRUE(receives(eye));
  EXPECT_EQ(eye.stats().lost, 0U);
  EXPECT_EQ(eye.stats().connections, 1U);
  EXPECT_EQ(server.connected(), 1U);
}

TEST_F(Loopback, SilentConnectionsKeepNobodyOut) {
  Server server(clock_);
  server.start();
  asio::io_context io;
  std::vector<tcp::socket> silent;
  for (int i = 0; i < 80; ++i)
    silent.emplace_back(io).connect({asio::ip::make_address("127.0.0.1"), server.port()});
  ServerLink eye(link(server.port()), clock_);
  EXPECT_NO_THROW(eye.waitForSession(1'500'000'000))
      << "before the silent ones are dropped for their silence";
  EXPECT_TRUE(receives(eye));
  EXPECT_EQ(eye.stats().connections, 1U);
  EXPECT_EQ(server.broadcaster().served(), 1U);
}

TEST_F(Loopback, AFullServerSaysSo) {
  Server server(clock_, 0, 1);
  ServerLink first(link(server.port()), clock_);
  first.waitForSession(kPatienceNs);
  ServerLink second(link(server.port()), clock_);
  try {
    second.waitForSession(1'000'000'000);
    FAIL() << "two clients where one is allowed";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("1 clients already"), std::string::npos) << error.what();
  }
}

/// Accepts one connection, reads the Hello and answers with what it is given.
void answerOnce(tcp::acceptor& acceptor, const Bytes& answer) {
  tcp::socket socket = acceptor.accept();
  std::array<std::byte, 256> hello;
  socket.read_some(asio::buffer(hello));
  asio::write(socket, asio::buffer(answer));
  boost::system::error_code ignored;
  socket.shutdown(tcp::socket::shutdown_send, ignored);
  socket.read_some(asio::buffer(hello), ignored);
}

TEST_F(Loopback, AServerOfAnotherVersionIsRefusedAtOnce) {
  // One says so itself; one just welcomes, as another version.
  const Bytes says = encodeControl(Goodbye{"this server speaks version 9.0", GoodbyeCause::Version});
  const Bytes welcomes{std::byte{0},    std::byte{0},    std::byte{0},    std::byte{4},
                       std::byte{0x12}, std::byte{0x02}, std::byte{0x08}, std::byte{0x09}};
  for (const Bytes& answer : {says, welcomes}) {
    asio::io_context io;
    tcp::acceptor acceptor(io, {asio::ip::make_address("127.0.0.1"), 0});
    std::thread server([&] { answerOnce(acceptor, answer); });
    ServerLink eye(link(acceptor.local_endpoint().port()), clock_);
    try {
      eye.waitForSession(kPatienceNs);
      ADD_FAILURE() << "joined a server of another version";
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("refused"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("version"), std::string::npos) << error.what();
    }
    server.join();
  }
}

TEST_F(Loopback, AClientOfAnotherVersionIsToldWhy) {
  Server server(clock_);
  asio::io_context io;
  tcp::socket socket(io);
  socket.connect({asio::ip::make_address("127.0.0.1"), server.port()});
  asio::write(socket, asio::buffer(encodeControl(Hello{kWireMajor + 1, 0, "", ""})));
  Bytes heard(1000);
  boost::system::error_code error;
  heard.resize(asio::read(socket, asio::buffer(heard), error));
  EXPECT_EQ(error, asio::error::eof);
  EXPECT_EQ(std::get<Goodbye>(messagesIn(heard).at(0)).cause, GoodbyeCause::Version);
  EXPECT_EQ(server.broadcaster().rejected().version, 1U);
}

TEST_F(Loopback, APortInUseIsNamedWithTheRemedy) {
  Server server(clock_);
  BroadcastConfig config;
  config.port = server.port();
  try {
    Broadcaster second(config, laboratory(), clock_);
    FAIL() << "two servers on one port";
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    for (const std::string& part : {std::string("127.0.0.1:"), std::to_string(server.port()),
                                    std::string("in use"), std::string("free port")}) {
      EXPECT_NE(text.find(part), std::string::npos) << text;
    }
  }
}

TEST_F(Loopback, AnAddressThatIsNoneOrNotOursIsNamed) {
  for (const char* address : {"nowhere", "192.0.2.77"}) {
    BroadcastConfig config;
    config.address = address;
    config.port = 0;
    try {
      Broadcaster broadcaster(config, laboratory(), clock_);
      FAIL() << "listens on " << address;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(address), std::string::npos) << error.what();
    }
  }
}

TEST_F(Loopback, AnUnreachableServerIsNamedAndTheLinkEndsPromptly) {
  std::uint16_t free_port = 0;
  {
    asio::io_context io;
    free_port = tcp::acceptor(io, {asio::ip::make_address("127.0.0.1"), 0}).local_endpoint().port();
  }
  // Nobody listens; a name that does not exist; an address that does not answer.
  for (const char* host : {"127.0.0.1", "no-such-host.invalid", "192.0.2.1"}) {
    ServerLink eye(link(free_port, "left", host), clock_);
    try {
      eye.waitForSession(100'000'000);
      FAIL() << "joined " << host;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(host), std::string::npos) << error.what();
    }
  }
  for (const char* host : {"127.0.0.1", "no-such-host.invalid", "192.0.2.1"}) {
    auto eye = std::make_unique<ServerLink>(link(free_port, "left", host), clock_);
    const std::int64_t before = clock_.nowNs();
    eye.reset();
    EXPECT_LT(clock_.nowNs() - before, 1'000'000'000) << host;
  }
}

TEST_F(Loopback, NamesAndSixServeAsWell) {
  BroadcastConfig config;
  config.address = "::1";
  config.port = 0;
  std::unique_ptr<Broadcaster> six;
  try {
    six = std::make_unique<Broadcaster>(config, laboratory(), clock_);
  } catch (const std::runtime_error& error) {
    GTEST_SKIP() << "no IPv6 here: " << error.what();
  }
  ServerLink eye(link(six->port(), "left", "::1"), clock_);
  EXPECT_NO_THROW(eye.waitForSession(kPatienceNs));
  EXPECT_TRUE(eventually([&] { return eye.stats().clock_known; }));
}

TEST_F(Loopback, ANameIsLookedUp) {
  Server server(clock_);
  ServerLink eye(link(server.port(), "left", "localhost"), clock_);
  EXPECT_NO_THROW(eye.waitForSession(kPatienceNs));
}

}  // namespace
}  // namespace coherency
