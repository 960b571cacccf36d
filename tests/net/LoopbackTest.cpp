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

#include "common/wire/Validity.h"
#include "motion_server/broadcast/Broadcaster.h"
#include "render_client/receive/ServerLink.h"
#include "tests/net/Relays.h"
#include "tests/net/Support.h"

// Real sockets on loopback. Nothing waits for a fixed time: every wait is for a condition and has a deadline
// that is generous enough for a loaded machine.

namespace coherency {
namespace {

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

BroadcastConfig anyPort() {
  BroadcastConfig config;
  config.port = 0;
  return config;
}

constexpr std::uint64_t kTicksAFrame = 8;

/// A server that publishes numbered samples about once a millisecond, and with every eighth a frame.
class Server {
 public:
  explicit Server(const Clock& clock, const BroadcastConfig& config = anyPort(),
                  const SessionConfig& session = laboratory())
      : clock_(clock), broadcaster_(config, session, clock) {}
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
    sample.server_time_ns = clock_.nowNs() + ahead_ns_;
    WorldState world = worldAt(sample.sequence);
    mode_ = broadcaster_.takeModeRequest().value_or(mode_);
    world.mode = mode_;
    world.movables[0].x_nm = moved_nm_;
    std::optional<FrameState> frame;
    if (sequence_ % kTicksAFrame == 0)
      frame = frameOf(sequence_ / kTicksAFrame, sequence_, sample.server_time_ns + 20'000'000, world);
    broadcaster_.publish(world, sample, frame);
  }
  /// Something in the world has been moved, and this long has passed for whoever makes keyframes.
  void move(std::int64_t nm, std::int64_t passed_ns) {
    moved_nm_ = nm;
    ahead_ns_ += passed_ns;
  }

  Broadcaster& broadcaster() { return broadcaster_; }
  std::uint16_t port() const { return broadcaster_.port(); }
  std::size_t connected() const { return broadcaster_.present(); }
  /// By which the only client there is is sent its motion.
  std::string way() const { return broadcaster_.clients().at(0).way; }

 private:
  const Clock& clock_;
  Broadcaster broadcaster_;
  std::uint64_t sequence_ = 0;
  Mode mode_ = Mode::Operator;
  std::atomic<std::int64_t> moved_nm_{0};
  std::atomic<std::int64_t> ahead_ns_{0};
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

/// Number and hash of the first frame in robot mode, of those an eye remembers.
std::pair<std::uint64_t, std::uint64_t> firstRobotFrame(const ServerLink& eye) {
  for (const ReceivedFrame& frame : eye.framesBetween(0, eye.newestFrame() + 1, 1))
    if (frame.state.world.mode == Mode::Robot) return {frame.state.number, frame.state.hash};
  return {0, 0};
}

TEST_F(Loopback, BothEyesSwitchModesAtTheFrameOneOfThemAskedFor) {
  Server server(clock_);
  ServerLink left(link(server.port(), "left"), clock_);
  ServerLink right(link(server.port(), "right"), clock_);
  server.start();
  ASSERT_TRUE(receives(left));
  ASSERT_TRUE(receives(right));
  ASSERT_TRUE(left.waitForFrame(1, kPatienceNs) && right.waitForFrame(1, kPatienceNs));
  left.requestMode(Mode::Robot);
  const auto inRobotMode = [](const ServerLink& eye) { return firstRobotFrame(eye).first != 0; };
  ASSERT_TRUE(eventually([&] { return inRobotMode(left) && inRobotMode(right); }));
  server.stop();
  EXPECT_GT(firstRobotFrame(left).first, 1U);
  EXPECT_EQ(firstRobotFrame(left), firstRobotFrame(right));
}

TEST_F(Loopback, FramesComeWithTheStateThatHasTheirHash) {
  Server server(clock_);
  ServerLink eye(link(server.port()), clock_);
  server.start();
  ASSERT_TRUE(eye.waitForFrame(20, kPatienceNs));
  const auto frames = eye.framesBetween(0, eye.newestFrame() + 1, 1);
  ASSERT_GE(frames.size(), 10U);
  for (const ReceivedFrame& frame : frames) {
    EXPECT_TRUE(hashHolds(frame.state));
    EXPECT_EQ(frame.state.world.tick, frame.state.number * kTicksAFrame);
    EXPECT_GE(frame.arrived.ns, frame.sampled.ns) << "one clock at both ends";
  }
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
  BroadcastConfig same_port;
  same_port.port = port;
  server.reset();
  EXPECT_TRUE(eventually([&] { return !left.stats().connected && !right.stats().connected; }));
  EXPECT_TRUE(left.newest());  // the last pose is held
  server = std::make_unique<Server>(clock_, same_port);
  server->start();
  for (const ServerLink* eye : {&left, &right}) {
    ASSERT_TRUE(eventually([&] { return eye->session()->session_id != first_session && eye->newest(); }));
    EXPECT_EQ(eye->stats().connections, 2U);
    EXPECT_TRUE(hashHolds(eye->newest()->packet));
  }
}

TEST_F(Loopback, AReportedFrameIsCompared) {
  Server server(clock_);
  ServerLink left(link(server.port(), "left"), clock_);
  ServerLink right(link(server.port(), "right"), clock_);
  left.waitForSession(kPatienceNs);
  right.waitForSession(kPatienceNs);
  left.reportFrame({5, Fate::Drawn, 40, 77, 1000, 900, 50});
  right.reportFrame({5, Fate::Drawn, 40, 77, 1500, 900, 50});
  EXPECT_TRUE(eventually([&] { return server.broadcaster().stereo().frames_agreeing == 1; }));
  EXPECT_EQ(server.broadcaster().stereo().present_skew_ns, std::vector<std::int64_t>{500});
  std::size_t reports = 0;  // taken where that needs no waiting
  EXPECT_TRUE(eventually([&] { return (reports += server.broadcaster().takeReports().size()) == 2; }));
}

std::uint64_t rejectedBy(Server& server) {
  const RejectCounts counts = server.broadcaster().rejected();
  return counts.malformed + counts.oversized + counts.version + counts.foreign + counts.forged;
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
  BroadcastConfig config = anyPort();
  config.max_clients = 1;
  Server server(clock_, config);
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
  // One says so itself; one just says hello, as another version.
  const Bytes says = inTheClear(Goodbye{"this server speaks version 9.0", GoodbyeCause::Version});
  const Bytes greets{std::byte{0},    std::byte{0},    std::byte{0},    std::byte{4},
                     std::byte{0x0a}, std::byte{0x02}, std::byte{0x08}, std::byte{0x09}};
  for (const Bytes& answer : {says, greets}) {
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
  Bytes hello = inTheClear(Hello{kWireMajor, 0, keyOf(1), false});
  hello.at(kControlPrefix + 3) = std::byte{kWireMajor + 1};
  asio::write(socket, asio::buffer(hello));
  Bytes heard(1000);
  boost::system::error_code error;
  heard.resize(asio::read(socket, asio::buffer(heard), error));
  EXPECT_EQ(error, asio::error::eof);
  EXPECT_EQ(as<Goodbye>(WireClient().hear(heard).at(0)).cause, GoodbyeCause::Version);
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

// ---- Keys ----

TEST_F(Loopback, WithTheKeyOneJoinsAndWithoutItOneIsToldSo) {
  BroadcastConfig config = anyPort();
  config.key = keyOf(9);
  Server server(clock_, config);
  server.start();
  LinkConfig right_key = link(server.port());
  right_key.key = keyOf(9);
  ServerLink eye(right_key, clock_);
  ASSERT_TRUE(receives(eye));
  LinkConfig wrong_key = right_key;
  wrong_key.key = keyOf(8);
  for (const LinkConfig& refused : {wrong_key, link(server.port())}) {
    ServerLink stranger(refused, clock_);
    try {
      stranger.waitForSession(kPatienceNs);
      ADD_FAILURE() << "joined with another key, or none";
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("refused"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("key"), std::string::npos) << error.what();
    }
  }
  EXPECT_EQ(server.connected(), 1U);
  EXPECT_TRUE(receives(eye));
}

TEST_F(Loopback, AKeyedClientDoesNotSpeakToAServerWithoutOne) {
  Server server(clock_);
  LinkConfig keyed = link(server.port());
  keyed.key = keyOf(9);
  ServerLink eye(keyed, clock_);
  EXPECT_THROW(eye.waitForSession(kPatienceNs), std::runtime_error);
  EXPECT_EQ(server.broadcaster().served(), 0U);
}

TEST_F(Loopback, ForgedDatagramsAreCountedAndRedirectNothing) {
  Server server(clock_);
  server.start();
  ServerLink eye(link(server.port()), clock_);
  ASSERT_TRUE(receives(eye));
  asio::io_context io;
  udp::socket forger(io, udp::v4());
  const std::uint32_t id = server.broadcaster().clients().at(0).id;
  DatagramSealer sealer(keyOf(66), id);
  for (int i = 0; i < 50; ++i)
    forger.send_to(asio::buffer(sealed(sealer, bodyOf(ClockProbe{clock_.nowNs()}))),
                   {asio::ip::make_address("127.0.0.1"), server.port()});
  EXPECT_TRUE(eventually([&] { return server.broadcaster().rejected().forged == 50; }));
  EXPECT_TRUE(receives(eye));
  forger.non_blocking(true);
  std::array<std::byte, 2000> bytes{};
  boost::system::error_code error;
  EXPECT_EQ(forger.receive(asio::buffer(bytes), 0, error), 0U) << "nothing is sent to who forges";
}

// ---- Keyframes ----

TEST_F(Loopback, AJoinerIsGivenTheKeyframeAndAnAskerAgain) {
  Server server(clock_);
  server.start();
  ServerLink eye(link(server.port()), clock_);
  ASSERT_TRUE(receives(eye));
  EXPECT_EQ(eye.newest()->packet.keyframe, 1U);
  const std::uint64_t before = eye.stats().keyframes;
  EXPECT_GE(before, 1U);
  eye.requestKeyframe();
  EXPECT_TRUE(eventually([&] { return eye.stats().keyframes > before; }));
  EXPECT_EQ(eye.stats().differing_field, "") << "it is the same";
}

TEST_F(Loopback, ANewKeyframeIsCountedFromWithoutLosingAnything) {
  Server server(clock_);
  server.start();
  ServerLink left(link(server.port(), "left"), clock_);
  ServerLink right(link(server.port(), "right"), clock_);
  ASSERT_TRUE(receives(left) && receives(right));
  for (const ServerLink* eye : {&left, &right})  // it has said which it has
    ASSERT_TRUE(eventually([&] { return eye->stats().clock_known; }));
  const std::uint64_t without = left.stats().without_keyframe + right.stats().without_keyframe;
  for (std::uint32_t number = 2; number <= 4; ++number) {
    server.move(1'000 * number, 6'000'000'000);
    for (const ServerLink* eye : {&left, &right})
      ASSERT_TRUE(eventually([&] { return eye->newest()->packet.keyframe == number; })) << number;
  }
  server.stop();
  EXPECT_EQ(left.stats().without_keyframe + right.stats().without_keyframe, without);
  for (const ServerLink* eye : {&left, &right}) {
    EXPECT_EQ(eye->stats().lost, 0U);
    EXPECT_TRUE(hashHolds(eye->newest()->packet));
    EXPECT_EQ(eye->newest()->packet.world.movables[0].x_nm, 4'000);
  }
}

// ---- Other ways ----

TEST_F(Loopback, WhereUdpIsBlockedMotionComesOverTcpAndGoesBackToUdpWhenItCan) {
  Server server(clock_);
  server.start();
  Relay relay(server.port());
  ServerLink eye(link(relay.port(), "left", Relay::kAddress), clock_);
  ASSERT_TRUE(receives(eye));
  EXPECT_EQ(eye.stats().way, MotionWay::Tcp);
  EXPECT_EQ(server.way(), "tcp");
  EXPECT_TRUE(eventually([&] { return eye.stats().clock_known; }));
  EXPECT_LE(std::abs(eye.stats().clock_offset_ns), eye.stats().clock_bound_ns);
  EXPECT_TRUE(hashHolds(eye.newest()->packet));
  ASSERT_TRUE(eye.waitForFrame(eye.newestFrame() + 3, kPatienceNs)) << "frames as well";

  relay.passUdp();
  ASSERT_TRUE(eventually([&] { return eye.stats().way == MotionWay::Udp && server.way() == "udp"; }));
  ASSERT_TRUE(receives(eye));

  relay.blockUdp();
  ASSERT_TRUE(eventually([&] { return eye.stats().way == MotionWay::Tcp && server.way() == "tcp"; }));
  ASSERT_TRUE(receives(eye));
  EXPECT_EQ(eye.stats().connections, 1U) << "all in one connection";
}

TEST_F(Loopback, WhoTakesNothingOverTcpHoldsNobodyUpAndIsGivenTheNewest) {
  Server server(clock_);
  server.start();
  ServerLink eye(link(server.port()), clock_);
  ASSERT_TRUE(receives(eye));
  // A client that has asked for motion over TCP and then does not read.
  asio::io_context io;
  tcp::socket socket(io, tcp::v4());
  socket.set_option(tcp::socket::receive_buffer_size(4096));
  socket.connect({asio::ip::make_address("127.0.0.1"), server.port()});
  WireClient stalled;
  asio::write(socket, asio::buffer(stalled.hello()));
  Bytes heard(1000);
  heard.resize(socket.read_some(asio::buffer(heard)));
  stalled.hear(heard);
  asio::write(socket, asio::buffer(stalled.say(Join{"right", ""})));
  asio::write(socket, asio::buffer(stalled.say(Tunnelled{bodyOf(ClockProbe{1, 0, MotionWay::Tcp})})));
  const auto status = [&] { return server.broadcaster().clients().at(1); };
  ASSERT_TRUE(eventually([&] { return server.connected() == 2 && status().packets_not_sent > 100; }))
      << "what it cannot take is left out, not kept";
  EXPECT_TRUE(receives(eye));
  EXPECT_EQ(eye.stats().lost, 0U);
}

TEST_F(Loopback, MotionOfAGroupIsSentOnceForAll) {
  const std::string group = "239.255.74.30";
  if (!multicastOnLoopback(group)) GTEST_SKIP() << "loopback carries no multicast here";
  SessionConfig session = laboratory();
  {
    asio::io_context io;  // a port that nobody uses
    session.multicast = {group, udp::socket(io, {asio::ip::make_address(group), 0}).local_endpoint().port()};
  }
  Server server(clock_, anyPort(), session);
  server.start();
  ServerLink left(link(server.port(), "left"), clock_);
  ServerLink right(link(server.port(), "right"), clock_);
  ASSERT_TRUE(receives(left) && receives(right));
  for (const ServerLink* eye : {&left, &right})
    EXPECT_TRUE(eventually([&] { return eye->stats().way == MotionWay::Multicast; }));
  EXPECT_TRUE(eventually([&] {
    const auto clients = server.broadcaster().clients();
    return clients.at(0).way == "multicast" && clients.at(1).way == "multicast";
  }));
  const LinkStats before = left.stats();
  ASSERT_TRUE(left.waitForTick(left.newest()->packet.world.tick + 200, kPatienceNs));
  EXPECT_EQ(left.stats().lost, before.lost);
  EXPECT_EQ(left.stats().rejected, before.rejected) << "nothing comes twice";
  EXPECT_EQ(left.stats().way, MotionWay::Multicast);
}

TEST_F(Loopback, WhoCannotHearTheGroupIsSentItsOwn) {
  SessionConfig session = laboratory();
  session.multicast = {"239.255.74.31", 7432};
  BroadcastConfig config = anyPort();
  config.address = "::1";  // IPv6 has no part in it
  std::unique_ptr<Server> server;
  try {
    server = std::make_unique<Server>(clock_, config, session);
  } catch (const std::runtime_error& error) {
    GTEST_SKIP() << "no IPv6 here: " << error.what();
  }
  server->start();
  ServerLink eye(link(server->port(), "left", "::1"), clock_);
  ASSERT_TRUE(receives(eye));
  EXPECT_EQ(eye.stats().way, MotionWay::Udp);
}

}  // namespace
}  // namespace coherency
