#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "motion_server/broadcast/SessionHost.h"
#include "tests/net/Support.h"

namespace coherency {
namespace {

using namespace testing;

class SessionHostTest : public ::testing::Test {
 protected:
  std::uint32_t connect() { return host_.open("192.0.2.1:5000", now_); }

  SessionHost::Reaction say(std::uint32_t connection, const Bytes& bytes) {
    return host_.receive(connection, bytes, now_);
  }

  SessionConfig join(const std::string& eye = "left") {
    const auto reaction = say(connect(), encodeControl(Hello{kWireMajor, kWireMinor, eye, "test"}));
    return std::get<SessionConfig>(messagesIn(reaction.send).at(0));
  }

  /// What the host says when it sends somebody away.
  static Goodbye farewell(const SessionHost::Reaction& reaction) {
    EXPECT_TRUE(reaction.goodbye);
    return std::get<Goodbye>(messagesIn(reaction.send).at(0));
  }

  std::optional<ClockReply> probe(const SessionConfig& session, std::int64_t t0 = 5,
                                  UdpAddress from = {{std::byte{2}, std::byte{1}}, 16}) {
    return host_.datagram(
        datagram(ClockProbe{session.session_id, session.client_id, session.client_token, t0}), from, now_);
  }
  static UdpAddress home(int port = 1) { return {{std::byte{2}, static_cast<std::byte>(port)}, 16}; }

  static BroadcastConfig config() {
    BroadcastConfig c;
    c.max_clients = 3;
    return c;
  }

  std::uint64_t random_ = 0;
  ServerTime now_{1'000'000'000};
  SessionHost host_{config(), laboratory(), [this] { return random_++; }};
};

TEST_F(SessionHostTest, WelcomesWithSessionIdsAndAToken) {
  const SessionConfig a = join("left");
  const SessionConfig b = join("right");
  EXPECT_EQ(a.session_id, host_.sessionId());
  EXPECT_NE(a.session_id, 0U);
  EXPECT_EQ(a.session_id, b.session_id);
  EXPECT_NE(a.client_id, b.client_id);
  EXPECT_NE(a.client_token, b.client_token);
  EXPECT_EQ(a.scene.name, "laboratory");
  ASSERT_EQ(host_.clients().size(), 2U);
  EXPECT_EQ(host_.clients()[1].eye, "right");
  EXPECT_EQ(host_.clients()[1].address, "192.0.2.1:5000");
}

TEST_F(SessionHostTest, MotionGoesWhereTheNewestProbeCameFrom) {
  const SessionConfig session = join();
  EXPECT_TRUE(host_.targets().empty());
  const auto before = host_.targetsVersion();
  const auto reply = probe(session, 77);
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->t0_client_ns, 77);
  EXPECT_EQ(reply->t1_server_ns, now_.ns);
  ASSERT_EQ(host_.targets().size(), 1U);
  EXPECT_EQ(host_.targets()[0].address, home());
  EXPECT_GT(host_.targetsVersion(), before);
  const auto unchanged = host_.targetsVersion();
  probe(session, 78);
  EXPECT_EQ(host_.targetsVersion(), unchanged);
  probe(session, 79, home(2));
  EXPECT_EQ(host_.targets()[0].address, home(2));
}

TEST_F(SessionHostTest, ForeignProbesAreCountedAndOpenNothing) {
  const SessionConfig session = join();
  SessionConfig wrong = session;
  wrong.session_id += 1;
  EXPECT_FALSE(probe(wrong));
  wrong = session;
  wrong.client_token ^= 1;
  EXPECT_FALSE(probe(wrong));
  wrong = session;
  wrong.client_id += 1;
  EXPECT_FALSE(probe(wrong));
  const std::uint32_t stranger = connect();  // connected, but never welcomed
  wrong = session;
  wrong.client_id = stranger;
  wrong.client_token = 0;
  EXPECT_FALSE(probe(wrong));
  EXPECT_EQ(host_.rejected().foreign, 4U);
  EXPECT_EQ(host_.rejected().malformed, 0U);
  EXPECT_TRUE(host_.targets().empty());
}

TEST_F(SessionHostTest, PassesOnWhatModeAClientAsksFor) {
  const SessionConfig client = join();
  const auto reaction = say(client.client_id, encodeControl(ModeRequest{Mode::Robot}));
  EXPECT_EQ(reaction.mode, Mode::Robot);
  EXPECT_FALSE(reaction.goodbye);
  EXPECT_TRUE(reaction.send.empty());
  EXPECT_FALSE(say(client.client_id, encodeControl(ClientReport{})).mode);
  const auto stranger = say(connect(), encodeControl(ModeRequest{Mode::Robot}));
  EXPECT_FALSE(stranger.mode);
  EXPECT_EQ(farewell(stranger).cause, GoodbyeCause::Protocol);
}

TEST_F(SessionHostTest, DatagramsThatNoClientSendsAreMalformed) {
  EXPECT_FALSE(host_.datagram(datagram(packet(host_.sessionId(), 1)), home(), now_));
  EXPECT_FALSE(host_.datagram(datagram(ClockReply{host_.sessionId(), 1, 2, 3}), home(), now_));
  EXPECT_FALSE(host_.datagram(Bytes(100, std::byte{0x55}), home(), now_));
  EXPECT_FALSE(host_.datagram(Bytes(kMaxDatagram + 1), home(), now_));
  EXPECT_EQ(host_.rejected().malformed, 3U);
  EXPECT_EQ(host_.rejected().oversized, 1U);
}

TEST_F(SessionHostTest, AnotherMajorVersionIsToldBothVersions) {
  const auto reaction = say(connect(), encodeControl(Hello{kWireMajor + 1, 4, "", ""}));
  const Goodbye goodbye = farewell(reaction);
  EXPECT_EQ(goodbye.cause, GoodbyeCause::Version);
  EXPECT_NE(goodbye.reason.find("2.0"), std::string::npos) << goodbye.reason;
  EXPECT_NE(goodbye.reason.find("3.4"), std::string::npos) << goodbye.reason;
  EXPECT_EQ(host_.rejected().version, 1U);
  EXPECT_TRUE(host_.clients().empty());
}

TEST_F(SessionHostTest, AFullHouseSaysSoAndHasRoomAgainWhenOneLeaves) {
  const SessionConfig first = join();
  join();
  join();
  const Goodbye goodbye = farewell(say(connect(), encodeControl(Hello{kWireMajor, 0, "left", ""})));
  EXPECT_EQ(goodbye.cause, GoodbyeCause::Full);
  EXPECT_NE(goodbye.reason.find('3'), std::string::npos) << goodbye.reason;
  host_.close(first.client_id);
  EXPECT_NO_THROW(join());
}

TEST_F(SessionHostTest, OfTooManyStrangersTheOldestGoes) {
  const SessionConfig client = join();
  const std::uint32_t oldest = connect();
  for (int i = 1; i < SessionHost::kStrangers; ++i) {
    connect();
    EXPECT_FALSE(host_.surplus());
  }
  connect();
  ASSERT_EQ(host_.surplus(), oldest) << "and not who was welcomed";
  host_.close(oldest);
  EXPECT_FALSE(host_.surplus());
  now_ = now_ + config().silence_ns;
  EXPECT_EQ(host_.expired(now_).size(), 1U + SessionHost::kStrangers);
  EXPECT_TRUE(probe(client));
}

TEST_F(SessionHostTest, WhoIsBeingSentAwayTakesAPlaceAmongStrangers) {
  const std::uint32_t first = connect();
  farewell(say(first, Bytes(64, std::byte{0xff})));
  for (int i = 0; i < SessionHost::kStrangers; ++i) connect();
  EXPECT_EQ(host_.surplus(), first);
}

TEST_F(SessionHostTest, ManyStrangersKeepNobodyOut) {
  for (int i = 0; i < 80; ++i) {
    connect();
    if (const auto surplus = host_.surplus()) host_.close(*surplus);
  }
  for (int i = 0; i < config().max_clients; ++i) {
    EXPECT_NO_THROW(join());
    if (const auto surplus = host_.surplus()) host_.close(*surplus);
  }
  EXPECT_EQ(host_.served(), 3U);
}

TEST_F(SessionHostTest, AnswersBeforeATooLongMessageAreStillSent) {
  Bytes both = encodeControl(Hello{kWireMajor, 0, "left", ""});
  both.insert(both.end(), 64, std::byte{0xff});
  const std::uint32_t connection = connect();
  now_ = now_ + config().silence_ns / 2;
  const auto reaction = say(connection, both);
  EXPECT_TRUE(reaction.goodbye);
  const auto messages = messagesIn(reaction.send);
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<SessionConfig>(messages[0]));
  EXPECT_EQ(std::get<Goodbye>(messages[1]).cause, GoodbyeCause::Protocol);
  now_ = now_ + SessionHost::kLingerNs - 1;
  EXPECT_TRUE(host_.expired(now_).empty()) << "the goodbye has its time to arrive";
}

TEST_F(SessionHostTest, WhatHasNoPlaceEndsTheConnection) {
  const Bytes hello = encodeControl(Hello{kWireMajor, 0, "left", ""});
  const Bytes report = encodeControl(ClientReport{});
  EXPECT_EQ(farewell(say(connect(), report)).cause, GoodbyeCause::Protocol);  // before hello
  const SessionConfig session = join();
  EXPECT_EQ(farewell(say(session.client_id, hello)).cause, GoodbyeCause::Protocol);  // a second time
  EXPECT_EQ(farewell(say(connect(), encodeControl(session))).cause, GoodbyeCause::Protocol);
  EXPECT_EQ(farewell(say(connect(), Bytes(64, std::byte{0}))).cause, GoodbyeCause::Protocol);
  EXPECT_EQ(farewell(say(connect(), Bytes(64, std::byte{0xff}))).cause, GoodbyeCause::Protocol);
  EXPECT_EQ(host_.rejected().malformed, 2U);
  EXPECT_EQ(host_.rejected().oversized, 1U);
}

TEST_F(SessionHostTest, AfterTheGoodbyeNothingCountsAnyMore) {
  const SessionConfig session = join();
  probe(session);
  EXPECT_EQ(host_.targets().size(), 1U);
  const auto reaction = say(session.client_id, encodeControl(Goodbye{"enough", GoodbyeCause::Leaving}));
  EXPECT_TRUE(reaction.goodbye);
  EXPECT_TRUE(reaction.send.empty());
  EXPECT_TRUE(host_.targets().empty());
  EXPECT_FALSE(probe(session));
  EXPECT_TRUE(say(session.client_id, encodeControl(Hello{kWireMajor, 0, "left", ""})).send.empty());
  EXPECT_FALSE(host_.clients().at(0).connected);
  now_ = now_ + SessionHost::kLingerNs;
  EXPECT_EQ(host_.expired(now_), std::vector<std::uint32_t>{session.client_id});
}

TEST_F(SessionHostTest, SilenceExpiresAndEitherPortIsASignOfLife) {
  const SessionConfig prober = join();
  const SessionConfig reporter = join();
  const SessionConfig silent = join();
  for (int i = 0; i < 4; ++i) {
    now_ = now_ + config().silence_ns / 4;
    probe(prober, i);
    say(reporter.client_id, encodeControl(ClientReport{}));
  }
  EXPECT_EQ(host_.expired(now_), std::vector<std::uint32_t>{silent.client_id});
}

TEST_F(SessionHostTest, AFloodEndsOnlyTheOneWhoFloods) {
  const SessionConfig flooder = join();
  const SessionConfig other = join();
  const Bytes report = encodeControl(ClientReport{});
  int heard = 0;
  while (!say(flooder.client_id, report).goodbye) ASSERT_LT(++heard, 1000);
  EXPECT_EQ(heard, SessionHost::kMessagesAtOnce - 1);  // hello was one
  EXPECT_FALSE(say(other.client_id, report).goodbye);
}

TEST_F(SessionHostTest, ReportsFeedStatusAndStereo) {
  const SessionConfig left = join("left");
  const SessionConfig right = join("right");
  say(left.client_id, encodeControl(ClientReport{{{10, 7, 100}, {11, 8, 200}}, 40, 2}));
  say(right.client_id, encodeControl(ClientReport{{{11, 8, 250}}, 41, 1}));
  EXPECT_EQ(host_.stereo().frames_compared, 1U);
  EXPECT_EQ(host_.stereo().frames_agreeing, 1U);
  const ClientStatus status = host_.clients().at(0);
  EXPECT_EQ(status.last_report.packets_received, 40U);
  EXPECT_EQ(status.last_report.packets_lost, 2U);
  EXPECT_TRUE(status.last_report.frames.empty());
}

TEST_F(SessionHostTest, ThePastIsRememberedWithinBounds) {
  for (int i = 0; i < 1000; ++i) {
    const SessionConfig session = join();
    probe(session);
    host_.targets().at(0).counts->sent = 9;
    host_.close(session.client_id);
  }
  const auto clients = host_.clients();
  EXPECT_EQ(clients.size(), 256U);
  EXPECT_EQ(clients.back().id, 1000U);
  EXPECT_EQ(clients.back().packets_sent, 9U);
  EXPECT_FALSE(clients.back().connected);
}

// Whatever bytes come in whatever pieces: no crash, and others are served as before.
RC_GTEST_FIXTURE_PROP(SessionHostTest, RandomBytesDisturbNobody,
                      (const std::vector<std::vector<std::uint8_t>>& noise)) {
  const SessionConfig good = join();
  const std::uint32_t stranger = connect();
  for (const auto& piece : noise) {
    const auto bytes = std::as_bytes(std::span(piece));
    host_.receive(stranger, bytes, now_);
    host_.datagram(bytes, home(9), now_);
  }
  RC_ASSERT(probe(good).has_value());
  RC_ASSERT(host_.targets().size() == 1);
  RC_ASSERT(host_.rejected().malformed >= noise.size());
}

}  // namespace
}  // namespace coherency
