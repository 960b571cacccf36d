#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "motion_server/broadcast/SessionHost.h"
#include "tests/net/Support.h"

namespace coherency {
namespace {

using namespace testing;

class SessionHostTest : public ::testing::Test {
 protected:
  std::uint32_t connect() { return host_->open("192.0.2.1:5000", now_); }

  SessionHost::Reaction say(std::uint32_t connection, const Bytes& bytes) {
    return host_->receive(connection, bytes, now_);
  }
  SessionHost::Reaction say(WireClient& client, const ControlMessage& message) {
    return say(client.id(), client.say(message));
  }

  /// Both hellos said.
  std::uint32_t greet(WireClient& client) {
    const std::uint32_t connection = connect();
    client.hear(say(connection, client.hello()).send);
    return connection;
  }
  WireClient join(const std::string& eye = "left", const Key& key = kNoKey) {
    WireClient client(key, ++clients_);
    const std::uint32_t connection = greet(client);
    const auto reaction = say(connection, client.say(Join{eye, "test"}));
    EXPECT_TRUE(reaction.wants_keyframes);
    as<SessionConfig>(client.hear(reaction.send).at(0));
    return client;
  }

  /// What the host says when it sends somebody away.
  static Goodbye farewell(WireClient& client, const SessionHost::Reaction& reaction) {
    EXPECT_TRUE(reaction.goodbye);
    return as<Goodbye>(client.hear(reaction.send).back());
  }
  Goodbye farewellOf(const Bytes& said) {
    WireClient client;
    return farewell(client, say(connect(), said));
  }

  static UdpAddress home(int port = 1) { return {{std::byte{2}, static_cast<std::byte>(port)}, 16}; }
  std::optional<SessionHost::Answer> deliver(Bytes bytes, const UdpAddress& from = home()) {
    return host_->datagram(bytes, from, now_);
  }
  std::optional<SessionHost::Answer> probe(WireClient& client, std::int64_t t0 = 5,
                                           const UdpAddress& from = home()) {
    return deliver(client.datagram({.t0_client_ns = t0}), from);
  }

  void beKeyed(const Key& key) {
    BroadcastConfig c = config();
    c.key = key;
    host_.emplace(c, laboratory(), [this] { return keyOf(++random_); });
  }
  static BroadcastConfig config() {
    BroadcastConfig c;
    c.max_clients = 3;
    return c;
  }

  int random_ = 1000;
  int clients_ = 0;
  ServerTime now_{1'000'000'000};
  std::optional<SessionHost> host_{std::in_place, config(), laboratory(),
                                   [this] { return keyOf(++random_); }};
};

TEST_F(SessionHostTest, WelcomesWithSessionIdsAndTheMotionKey) {
  const WireClient a = join("left");
  const WireClient b = join("right");
  EXPECT_EQ(a.session().session_id, host_->sessionId());
  EXPECT_NE(a.session().session_id, 0U);
  EXPECT_EQ(a.session().session_id, b.session().session_id);
  EXPECT_NE(a.id(), b.id());
  EXPECT_EQ(a.session().motion_key, host_->motionKey());
  EXPECT_NE(host_->motionKey(), kNoKey);
  EXPECT_NE(a.keys(), b.keys()) << "each connection has keys of its own";
  EXPECT_EQ(a.session().scene.name, "laboratory");
  ASSERT_EQ(host_->clients().size(), 2U);
  EXPECT_EQ(host_->clients()[1].eye, "right");
  EXPECT_EQ(host_->clients()[1].address, "192.0.2.1:5000");
}

// ---- The handshake ----

TEST_F(SessionHostTest, WithTheSameKeyBothEndsSpeak) {
  beKeyed(keyOf(9));
  WireClient client = join("left", keyOf(9));
  EXPECT_TRUE(probe(client));
  EXPECT_EQ(host_->rejected().forged, 0U);
}

TEST_F(SessionHostTest, AnotherKeyIsRefusedAsThat) {
  beKeyed(keyOf(9));
  WireClient client(keyOf(8));
  const std::uint32_t connection = greet(client);
  const auto goodbye = farewell(client, say(connection, client.say(Join{"left", ""})));
  EXPECT_EQ(goodbye.cause, GoodbyeCause::Key);
  EXPECT_NE(goodbye.reason.find("another key"), std::string::npos) << goodbye.reason;
  EXPECT_EQ(host_->rejected().forged, 1U);
  EXPECT_TRUE(host_->clients().empty());
  const auto refusals = host_->takeRefusals();
  ASSERT_EQ(refusals.size(), 1U);
  EXPECT_NE(refusals[0].find("refused: " + goodbye.reason), std::string::npos) << refusals[0];
  EXPECT_TRUE(host_->takeRefusals().empty()) << "said once";
}

TEST_F(SessionHostTest, OfManyRefusalsTheNewestAreSaid) {
  for (int i = 0; i < 100; ++i) {
    Hello hello;
    hello.major = 100 + static_cast<std::uint32_t>(i);
    say(connect(), inTheClear(hello));
  }
  const auto refusals = host_->takeRefusals();
  ASSERT_FALSE(refusals.empty());
  EXPECT_LT(refusals.size(), 20U);
  EXPECT_NE(refusals.back().find("199."), std::string::npos) << refusals.back();
}

TEST_F(SessionHostTest, NoKeyWhereThereIsOneAndTheOtherWayRound) {
  WireClient keyed(keyOf(9));
  const auto needless = farewell(keyed, say(connect(), keyed.hello()));
  EXPECT_EQ(needless.cause, GoodbyeCause::Key);
  EXPECT_NE(needless.reason.find("leave --key out"), std::string::npos) << needless.reason;
  EXPECT_EQ(host_->rejected().foreign, 1U);
  beKeyed(keyOf(9));
  WireClient open;
  const auto missing = farewell(open, say(connect(), open.hello()));
  EXPECT_EQ(missing.cause, GoodbyeCause::Key);
  EXPECT_NE(missing.reason.find("give --key FILE"), std::string::npos) << missing.reason;
  EXPECT_EQ(host_->rejected().foreign, 1U);
}

TEST_F(SessionHostTest, WhatIsNoPublicKeyIsRefused) {
  Hello hello;  // all zeros: every secret makes zero of it
  EXPECT_EQ(farewellOf(inTheClear(hello)).cause, GoodbyeCause::Protocol);
  EXPECT_TRUE(host_->clients().empty());
}

TEST_F(SessionHostTest, InTheClearNothingIsHeardAfterTheHellos) {
  for (const ControlMessage& message :
       {ControlMessage(Join{"left", ""}), ControlMessage(ClientReport{}), ControlMessage(KeyframeRequest{}),
        ControlMessage(Hello{kWireMajor, kWireMinor, keyOf(3), false})}) {
    WireClient client(kNoKey, ++clients_);
    const std::uint32_t connection = greet(client);
    EXPECT_EQ(farewell(client, say(connection, inTheClear(message))).cause, GoodbyeCause::Protocol);
  }
  EXPECT_EQ(host_->rejected().malformed, 4U);
  EXPECT_TRUE(host_->clients().empty());
}

TEST_F(SessionHostTest, AWelcomedClientIsNotSentAwayInTheClear) {
  WireClient client = join();
  const auto reaction = say(client.id(), inTheClear(Goodbye{"it is not me", GoodbyeCause::Leaving}));
  EXPECT_EQ(host_->rejected().forged, 1U);
  EXPECT_EQ(farewell(client, reaction).cause, GoodbyeCause::Protocol) << "the stream was tampered with";
}

TEST_F(SessionHostTest, ASealedMessageSaidAgainIsForged) {
  WireClient client = join();
  const Bytes report = client.say(ClientReport{});
  EXPECT_FALSE(say(client.id(), report).goodbye);
  EXPECT_TRUE(say(client.id(), report).goodbye);
  EXPECT_EQ(host_->rejected().forged, 1U);
}

TEST_F(SessionHostTest, WhatHasNoPlaceEndsTheConnection) {
  EXPECT_EQ(farewellOf(inTheClear(ClientReport{})).cause, GoodbyeCause::Protocol);
  EXPECT_EQ(farewellOf(inTheClear(Join{"left", ""})).cause, GoodbyeCause::Protocol) << "before hello";
  EXPECT_EQ(farewellOf(Bytes(64, std::byte{0})).cause, GoodbyeCause::Protocol);
  EXPECT_EQ(farewellOf(Bytes(64, std::byte{0xff})).cause, GoodbyeCause::Protocol);
  EXPECT_EQ(host_->rejected().malformed, 3U);
  EXPECT_EQ(host_->rejected().oversized, 1U);

  WireClient early(kNoKey, 50);
  const std::uint32_t connection = greet(early);
  EXPECT_EQ(farewell(early, say(connection, early.say(ClientReport{}))).cause, GoodbyeCause::Protocol)
      << "before joining";
  WireClient twice = join();
  EXPECT_EQ(farewell(twice, say(twice, Hello{kWireMajor, 0, keyOf(3), false})).cause, GoodbyeCause::Protocol);
  WireClient again = join();
  EXPECT_EQ(farewell(again, say(again, Join{"left", ""})).cause, GoodbyeCause::Protocol);
  WireClient posing = join();
  EXPECT_EQ(farewell(posing, say(posing, posing.session())).cause, GoodbyeCause::Protocol);
  WireClient inventing = join();
  EXPECT_EQ(farewell(inventing, say(inventing, Keyframe{1, {}})).cause, GoodbyeCause::Protocol);
}

TEST_F(SessionHostTest, AnotherMajorVersionIsToldBothVersions) {
  Bytes hello = inTheClear(Hello{kWireMajor, 4, keyOf(3), false});
  hello.at(kControlPrefix + 3) = std::byte{kWireMajor + 1};  // hello { major
  const Goodbye goodbye = farewellOf(hello);
  EXPECT_EQ(goodbye.cause, GoodbyeCause::Version);
  EXPECT_NE(goodbye.reason.find("version 3.0"), std::string::npos) << goodbye.reason;
  EXPECT_NE(goodbye.reason.find("this client 4."), std::string::npos) << goodbye.reason;
  EXPECT_EQ(host_->rejected().version, 1U);
  EXPECT_TRUE(host_->clients().empty());
}

// ---- Datagrams ----

TEST_F(SessionHostTest, MotionGoesWhereTheNewestProbeCameFrom) {
  WireClient client = join();
  EXPECT_TRUE(host_->targets().empty());
  const auto before = host_->targetsVersion();
  const auto answer = probe(client, 77);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->reply.t0_client_ns, 77);
  EXPECT_EQ(answer->reply.t1_server_ns, now_.ns);
  ASSERT_EQ(host_->targets().size(), 1U);
  EXPECT_EQ(host_->targets()[0].address, home());
  EXPECT_EQ(host_->targets()[0].way, MotionWay::Udp);
  EXPECT_EQ(host_->clients()[0].way, "udp");
  EXPECT_GT(host_->targetsVersion(), before);
  const auto unchanged = host_->targetsVersion();
  probe(client, 78);
  EXPECT_EQ(host_->targetsVersion(), unchanged);
  probe(client, 79, home(2));
  EXPECT_EQ(host_->targets()[0].address, home(2));
}

TEST_F(SessionHostTest, AnAnswerIsSealedForItsClientAlone) {
  WireClient client = join();
  WireClient other = join();
  const auto answer = probe(client, 77);
  Bytes bytes;
  host_->encode(*answer, bytes);
  Bytes copy = bytes;
  EXPECT_EQ(std::get<Reject>(other.opener().open(copy)), Reject::Forged);
  const auto body = std::get<std::span<const std::byte>>(client.opener().open(bytes));
  EXPECT_EQ(std::get<ClockReply>(DatagramCodec().decode(body, {})), answer->reply);
}

TEST_F(SessionHostTest, AProbeSaidAgainFromElsewhereRedirectsNothing) {
  WireClient client = join();
  const Bytes heard = client.datagram({.t0_client_ns = 5});
  EXPECT_TRUE(deliver(heard, home(1)));
  const auto version = host_->targetsVersion();
  EXPECT_FALSE(deliver(heard, home(66)));
  EXPECT_EQ(host_->targets()[0].address, home(1));
  EXPECT_EQ(host_->targetsVersion(), version);
  EXPECT_EQ(host_->rejected().replayed, 1U);
}

TEST_F(SessionHostTest, AProbeHeldBackAndThenSentFromElsewhereRedirectsNothing) {
  WireClient client = join();
  const Bytes held_back = client.datagram({.t0_client_ns = 5, .keyframe = 1});
  EXPECT_TRUE(deliver(client.datagram({.t0_client_ns = 6, .keyframe = 2}), home(1)));
  deliver(held_back, home(66));
  EXPECT_EQ(host_->targets()[0].address, home(1));
  EXPECT_EQ(host_->keyframeOfAll(), 2U);
}

TEST_F(SessionHostTest, ForgedAndForeignProbesAreCountedAndOpenNothing) {
  WireClient client = join();
  const Bytes genuine = client.datagram({.t0_client_ns = 5});
  for (std::size_t i = kSealedHeader - 8; i < genuine.size(); ++i) {  // counter, body and tag
    Bytes changed = genuine;
    changed[i] ^= std::byte{1};
    EXPECT_FALSE(deliver(changed)) << i;
  }
  EXPECT_EQ(host_->rejected().forged, genuine.size() - kSealedHeader + 8);
  DatagramSealer posing(client.keys().client_datagrams, kMotionChannel);
  EXPECT_FALSE(deliver(sealed(posing, bodyOf(ClockProbe{5}))));
  DatagramSealer nobody(client.keys().client_datagrams, client.id() + 1);
  EXPECT_FALSE(deliver(sealed(nobody, bodyOf(ClockProbe{5}))));
  WireClient stranger(kNoKey, 70);  // has keys, but was never welcomed
  const std::uint32_t connection = greet(stranger);
  DatagramSealer early(stranger.keys().client_datagrams, connection);
  EXPECT_FALSE(deliver(sealed(early, bodyOf(ClockProbe{5}))));
  EXPECT_EQ(host_->rejected().foreign, 3U);
  WireClient other = join();
  DatagramSealer envious(other.keys().client_datagrams, client.id());
  const auto forged = host_->rejected().forged;
  EXPECT_FALSE(deliver(sealed(envious, bodyOf(ClockProbe{5})), home(66)));
  DatagramSealer echo(client.keys().server_datagrams, client.id());
  EXPECT_FALSE(deliver(sealed(echo, bodyOf(ClockProbe{5})), home(66)))
      << "the server's own are not the client's";
  EXPECT_EQ(host_->rejected().forged, forged + 2);
  EXPECT_EQ(host_->rejected().malformed, 0U);
  EXPECT_TRUE(host_->targets().empty());
  EXPECT_TRUE(deliver(genuine)) << "what was forged in its name has not used up its counter";
}

TEST_F(SessionHostTest, DatagramsThatNoClientSendsAreMalformed) {
  WireClient client = join();
  DatagramSealer sealer(client.keys().client_datagrams, client.id());
  Bytes motion;
  DatagramCodec().encode(packet(1), worldAt(0), motion);
  EXPECT_FALSE(deliver(sealed(sealer, motion)));
  EXPECT_FALSE(deliver(sealed(sealer, bodyOf(ClockReply{1, 2, 3}))));
  EXPECT_FALSE(deliver(Bytes(100, std::byte{0x55})));
  EXPECT_FALSE(deliver({}));
  EXPECT_EQ(host_->rejected().malformed, 4U);
  EXPECT_FALSE(deliver(Bytes(kMaxDatagram + 1)));
  EXPECT_EQ(host_->rejected().oversized, 1U);
  Bytes newer = client.datagram({});
  newer[3] = std::byte{kSealedMajor + 1};
  EXPECT_FALSE(deliver(newer));
  EXPECT_EQ(host_->rejected().version, 1U);
  EXPECT_TRUE(host_->targets().empty());
}

TEST_F(SessionHostTest, AProbeByTcpIsAnsweredThereAndBringsMotionThere) {
  WireClient client = join();
  const auto reaction = say(client, Tunnelled{bodyOf(ClockProbe{77, 4, MotionWay::Tcp})});
  const auto answer = as<Tunnelled>(client.hear(reaction.send).at(0));
  EXPECT_EQ(std::get<ClockReply>(DatagramCodec().decode(answer.body, {})),
            (ClockReply{77, now_.ns, now_.ns}));
  EXPECT_EQ(host_->tunnels(), std::vector<std::uint32_t>{client.id()});
  EXPECT_EQ(host_->targets().at(0).way, MotionWay::Tcp);
  EXPECT_EQ(host_->clients()[0].way, "tcp");
  EXPECT_EQ(host_->keyframeOfAll(), 4U);
  host_->countTunnelled(client.id(), true);
  host_->countTunnelled(client.id(), false);
  host_->countTunnelled(99, true);
  EXPECT_EQ(host_->clients()[0].packets_sent, 1U);
  EXPECT_EQ(host_->clients()[0].packets_not_sent, 1U);
  probe(client, 78);
  EXPECT_TRUE(host_->tunnels().empty()) << "UDP works again";
  EXPECT_EQ(host_->clients()[0].way, "udp");
}

TEST_F(SessionHostTest, OnlyProbesComeByTcp) {
  for (const Bytes& body : {bodyOf(ClockReply{1, 2, 3}), Bytes(20, std::byte{0x55})}) {
    WireClient client = join();
    EXPECT_EQ(farewell(client, say(client, Tunnelled{body})).cause, GoodbyeCause::Protocol);
  }
  WireClient early(kNoKey, 50);
  const std::uint32_t connection = greet(early);
  EXPECT_TRUE(say(connection, early.say(Tunnelled{bodyOf(ClockProbe{1})})).goodbye);
  EXPECT_EQ(host_->rejected().malformed, 3U);
  EXPECT_TRUE(host_->tunnels().empty());
}

TEST_F(SessionHostTest, AProbeSaysByWhichWayItsClientHears) {
  WireClient client = join();
  deliver(client.datagram({.t0_client_ns = 5, .way = MotionWay::Multicast}));
  EXPECT_EQ(host_->targets().at(0).way, MotionWay::Multicast);
  EXPECT_EQ(host_->clients()[0].way, "multicast");
}

// ---- Keyframes ----

TEST_F(SessionHostTest, TheKeyframeOfAllIsTheOldestAmongThoseWhoAreSentMotion) {
  EXPECT_EQ(host_->keyframeOfAll(), ~std::uint32_t{0});
  WireClient a = join();
  EXPECT_EQ(host_->keyframeOfAll(), ~std::uint32_t{0}) << "it has not asked for motion yet";
  WireClient b = join();
  deliver(a.datagram({.t0_client_ns = 1, .keyframe = 7}));
  EXPECT_EQ(host_->keyframeOfAll(), 7U);
  deliver(b.datagram({.t0_client_ns = 1, .keyframe = 6}));
  EXPECT_EQ(host_->keyframeOfAll(), 6U);
  deliver(b.datagram({.t0_client_ns = 2, .keyframe = 8}));
  EXPECT_EQ(host_->keyframeOfAll(), 7U);
  host_->close(a.id());
  EXPECT_EQ(host_->keyframeOfAll(), 8U);
}

TEST_F(SessionHostTest, AKeyframeRequestIsPassedOn) {
  WireClient client = join();
  const auto reaction = say(client, KeyframeRequest{});
  EXPECT_TRUE(reaction.wants_keyframes);
  EXPECT_FALSE(reaction.goodbye);
  const Keyframe keyframe{3, worldAt(5)};
  EXPECT_EQ(as<Keyframe>(client.hear(host_->tell(client.id(), keyframe)).at(0)), keyframe);
  EXPECT_TRUE(host_->tell(connect(), keyframe).empty()) << "nobody else is told";
  EXPECT_TRUE(host_->tell(99, keyframe).empty());
}

// ---- Who is here ----

TEST_F(SessionHostTest, PassesOnWhatModeAClientAsksFor) {
  WireClient client = join();
  const auto reaction = say(client, ModeRequest{Mode::Robot});
  EXPECT_EQ(reaction.mode, Mode::Robot);
  EXPECT_FALSE(reaction.goodbye);
  EXPECT_TRUE(reaction.send.empty());
  EXPECT_FALSE(say(client, ClientReport{}).mode);
  WireClient early(kNoKey, 50);
  const std::uint32_t connection = greet(early);
  const auto too_soon = say(connection, early.say(ModeRequest{Mode::Robot}));
  EXPECT_FALSE(too_soon.mode);
  EXPECT_EQ(farewell(early, too_soon).cause, GoodbyeCause::Protocol);
}

TEST_F(SessionHostTest, AFullHouseSaysSoAndHasRoomAgainWhenOneLeaves) {
  const WireClient first = join();
  join();
  join();
  WireClient fourth(kNoKey, 50);
  const std::uint32_t connection = greet(fourth);
  const Goodbye goodbye = farewell(fourth, say(connection, fourth.say(Join{"left", ""})));
  EXPECT_EQ(goodbye.cause, GoodbyeCause::Full);
  EXPECT_NE(goodbye.reason.find('3'), std::string::npos) << goodbye.reason;
  host_->close(first.id());
  EXPECT_NO_THROW(join());
}

TEST_F(SessionHostTest, OfTooManyStrangersTheOldestGoes) {
  WireClient client = join();
  const std::uint32_t oldest = connect();
  for (int i = 1; i < SessionHost::kStrangers; ++i) {
    WireClient greeted(kNoKey, 50 + i);  // a hello alone makes nobody welcome
    greet(greeted);
    EXPECT_FALSE(host_->surplus());
  }
  connect();
  ASSERT_EQ(host_->surplus(), oldest) << "and not who was welcomed";
  host_->close(oldest);
  EXPECT_FALSE(host_->surplus());
  now_ = now_ + config().silence_ns;
  EXPECT_EQ(host_->expired(now_).size(), 1U + SessionHost::kStrangers);
  EXPECT_TRUE(probe(client));
}

TEST_F(SessionHostTest, WhoIsBeingSentAwayTakesAPlaceAmongStrangers) {
  const std::uint32_t first = connect();
  EXPECT_TRUE(say(first, Bytes(64, std::byte{0xff})).goodbye);
  for (int i = 0; i < SessionHost::kStrangers; ++i) connect();
  EXPECT_EQ(host_->surplus(), first);
}

TEST_F(SessionHostTest, ManyStrangersKeepNobodyOut) {
  for (int i = 0; i < 80; ++i) {
    connect();
    if (const auto surplus = host_->surplus()) host_->close(*surplus);
  }
  for (int i = 0; i < config().max_clients; ++i) {
    EXPECT_NO_THROW(join());
    if (const auto surplus = host_->surplus()) host_->close(*surplus);
  }
  EXPECT_EQ(host_->served(), 3U);
}

TEST_F(SessionHostTest, AnswersBeforeATooLongMessageAreStillSent) {
  WireClient client;
  const std::uint32_t connection = greet(client);
  Bytes both = client.say(Join{"left", ""});
  both.insert(both.end(), 64, std::byte{0xff});
  now_ = now_ + config().silence_ns / 2;
  const auto reaction = say(connection, both);
  EXPECT_TRUE(reaction.goodbye);
  const auto messages = client.hear(reaction.send);
  ASSERT_EQ(messages.size(), 2U);
  as<SessionConfig>(messages[0]);
  EXPECT_EQ(as<Goodbye>(messages[1]).cause, GoodbyeCause::Protocol);
  now_ = now_ + SessionHost::kLingerNs - 1;
  EXPECT_TRUE(host_->expired(now_).empty()) << "the goodbye has its time to arrive";
}

TEST_F(SessionHostTest, AfterTheGoodbyeNothingCountsAnyMore) {
  WireClient client = join();
  probe(client);
  EXPECT_EQ(host_->targets().size(), 1U);
  const auto reaction = say(client, Goodbye{"enough", GoodbyeCause::Leaving});
  EXPECT_TRUE(reaction.goodbye);
  EXPECT_TRUE(reaction.send.empty());
  EXPECT_TRUE(host_->targets().empty());
  EXPECT_FALSE(probe(client, 6));
  EXPECT_TRUE(say(client, ClientReport{}).send.empty());
  EXPECT_FALSE(host_->clients().at(0).connected);
  now_ = now_ + SessionHost::kLingerNs;
  EXPECT_EQ(host_->expired(now_), std::vector<std::uint32_t>{client.id()});
}

TEST_F(SessionHostTest, SilenceExpiresAndEitherPortIsASignOfLife) {
  WireClient prober = join();
  WireClient reporter = join();
  WireClient silent = join();
  Bytes forged = silent.datagram({});
  forged.back() ^= std::byte{1};
  for (int i = 0; i < 4; ++i) {
    now_ = now_ + config().silence_ns / 4;
    probe(prober, i);
    say(reporter, ClientReport{});
    deliver(forged);  // by somebody else: no sign of its life
  }
  EXPECT_EQ(host_->expired(now_), std::vector<std::uint32_t>{silent.id()});
}

TEST_F(SessionHostTest, AFloodEndsOnlyTheOneWhoFloods) {
  WireClient flooder = join();
  WireClient other = join();
  int heard = 0;
  while (!say(flooder, ClientReport{}).goodbye) ASSERT_LT(++heard, 1000);
  EXPECT_EQ(heard, SessionHost::kMessagesAtOnce - 2);  // hello and join were two
  EXPECT_FALSE(say(other, ClientReport{}).goodbye);
}

TEST_F(SessionHostTest, ReportsFeedStatusStereoAndWhoTakesThem) {
  WireClient left = join("left");
  WireClient right = join("right");
  const auto drawn = [](std::uint64_t number, std::int64_t presented_ns) {
    return FrameReport{number, Fate::Drawn, number, number, presented_ns, 1, 2};
  };
  say(left, ClientReport{{drawn(10, 100), drawn(11, 200)}, 40, 2});
  say(right, ClientReport{{drawn(11, 250)}, 41, 1});
  EXPECT_EQ(host_->stereo().frames_compared, 1U);
  EXPECT_EQ(host_->stereo().frames_agreeing, 1U);
  const ClientStatus status = host_->clients().at(0);
  EXPECT_EQ(status.last_report.packets_received, 40U);
  EXPECT_EQ(status.last_report.packets_lost, 2U);
  EXPECT_TRUE(status.last_report.frames.empty());
  EXPECT_EQ(host_->takeReports(), (std::vector{drawn(10, 100), drawn(11, 200), drawn(11, 250)}));
  EXPECT_TRUE(host_->takeReports().empty());
}

TEST_F(SessionHostTest, ReportsThatNobodyTakesAreBounded) {
  WireClient client = join();
  for (std::uint64_t i = 0; i < 20; ++i) {
    ClientReport report;
    for (std::uint64_t n = 1; n <= 500; ++n) report.frames.push_back({.number = i * 500 + n});
    say(client, report);
  }
  const auto reports = host_->takeReports();
  EXPECT_EQ(reports.size(), 4096U);
  EXPECT_EQ(reports.back().number, 10'000U);
}

TEST_F(SessionHostTest, ThePastIsRememberedWithinBounds) {
  for (int i = 0; i < 1000; ++i) {
    WireClient client = join();
    probe(client);
    host_->targets().at(0).counts->sent = 9;
    host_->close(client.id());
  }
  const auto clients = host_->clients();
  EXPECT_EQ(clients.size(), 256U);
  EXPECT_EQ(clients.back().id, 1000U);
  EXPECT_EQ(clients.back().packets_sent, 9U);
  EXPECT_FALSE(clients.back().connected);
}

// Whatever bytes come in whatever pieces: no crash, and others are served as before.
RC_GTEST_FIXTURE_PROP(SessionHostTest, RandomBytesDisturbNobody,
                      (const std::vector<std::vector<std::uint8_t>>& noise)) {
  WireClient good = join();
  const std::uint32_t stranger = connect();
  std::uint64_t refused = 0;
  for (const auto& piece : noise) {
    const auto bytes = std::as_bytes(std::span(piece));
    host_->receive(stranger, bytes, now_);
    deliver(Bytes(bytes.begin(), bytes.end()), home(9));
    ++refused;
  }
  RC_ASSERT(probe(good).has_value());
  RC_ASSERT(host_->targets().size() == 1);
  const RejectCounts& rejected = host_->rejected();
  RC_ASSERT(rejected.malformed + rejected.foreign + rejected.version >= refused);
}

}  // namespace
}  // namespace coherency
