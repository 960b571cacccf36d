#include <stdexcept>

#include <gtest/gtest.h>

#include "common/wire/Validity.h"
#include "render_client/receive/LinkState.h"
#include "tests/net/Support.h"

namespace coherency {
namespace {

using namespace testing;

/// The server's end: what it seals with.
struct ServerEnd {
  explicit ServerEnd(int number)
      : keys{keyOf(number + 1), keyOf(number + 2), keyOf(number + 3), keyOf(number + 4)},
        motion_key(keyOf(number)),
        motion(motion_key, kMotionChannel),
        replies(keys.server_datagrams, kClient),
        probes(keys.client_datagrams, kClient) {}
  static constexpr std::uint32_t kClient = 3;

  SessionConfig session() const {
    SessionConfig s = laboratory();
    s.session_id = static_cast<std::uint64_t>(std::to_integer<int>(motion_key[4]));
    s.client_id = kClient;
    s.motion_key = motion_key;
    return s;
  }
  /// Another connection to the same session has other keys of its own.
  void reconnect(int number) {
    keys = {keyOf(number + 1), keyOf(number + 2), keyOf(number + 3), keyOf(number + 4)};
    replies = DatagramSealer(keys.server_datagrams, kClient);
    probes = DatagramOpener(keys.client_datagrams, kClient);
  }
  Bytes seal(const MotionPacket& p) {
    Bytes body;
    codec.encode(p, keyframe.world, body);
    return sealed(motion, body);
  }
  Bytes seal(const ClockReply& reply) { return sealed(replies, bodyOf(reply)); }
  ClockProbe open(Bytes probe) {
    const auto body = std::get<std::span<const std::byte>>(probes.open(probe));
    return std::get<ClockProbe>(codec.decode(body, {}));
  }

  ConnectionKeys keys;
  Key motion_key;
  DatagramSealer motion;
  DatagramSealer replies;
  DatagramOpener probes;
  DatagramCodec codec;
  Keyframe keyframe{1, worldAt(0)};
};

class LinkStateTest : public ::testing::Test {
 protected:
  void welcome(ServerEnd& server) {
    link_.welcomed(server.session(), server.keys);
    link_.take(server.keyframe);
  }
  bool deliver(Bytes bytes) { return link_.datagram(bytes, {clock_.nowNs()}) >= LinkState::Heard::Reply; }
  bool receive(std::uint64_t sequence) { return deliver(server_.seal(packet(sequence))); }
  ClockProbe ask(MotionWay way = MotionWay::Udp) {
    Bytes bytes;
    link_.encodeProbe(way, bytes);
    return server_.open(bytes);
  }

  ManualClock clock_;
  LinkState link_{{"server.example", 7430, "left"}, clock_};
  ServerEnd server_{10};
};

std::string errorOf(const LinkState& link) {
  try {
    link.waitForSession(0);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST_F(LinkStateTest, WithoutASessionTheErrorNamesPlaceReasonAndRemedy) {
  link_.disconnected("Connection refused");
  const std::string error = errorOf(link_);
  for (const char* part : {"server.example:7430", "Connection refused", "start motion_server"}) {
    EXPECT_NE(error.find(part), std::string::npos) << error;
  }
}

TEST_F(LinkStateTest, AnotherVersionOrKeyIsFinalAFullServerIsNot) {
  for (const GoodbyeCause cause : {GoodbyeCause::Version, GoodbyeCause::Key}) {
    LinkState link({"server.example", 7430, "left"}, clock_);
    link.refused({"3 clients already", GoodbyeCause::Full});
    EXPECT_NE(errorOf(link).find("within"), std::string::npos) << errorOf(link);
    EXPECT_NE(errorOf(link).find("3 clients already"), std::string::npos) << errorOf(link);
    link.refused({"it is another", cause});
    EXPECT_NE(errorOf(link).find("refused: it is another"), std::string::npos) << errorOf(link);
    EXPECT_EQ(errorOf(link).find("within"), std::string::npos) << errorOf(link);
  }
}

TEST_F(LinkStateTest, TheNewestWinsAndFramesAreTakenOnce) {
  welcome(server_);
  EXPECT_FALSE(link_.newest());
  EXPECT_TRUE(receive(10));
  EXPECT_TRUE(receive(12));
  EXPECT_TRUE(receive(11));
  EXPECT_EQ(link_.newest()->packet.sample.sequence, 12U);
  EXPECT_EQ(link_.nextFrame(0, 1, {0}, 0)->state, packet(10).frames[0]);
  EXPECT_EQ(link_.nextFrame(10, 1, {0}, 0)->state.number, 11U);
  EXPECT_EQ(link_.newestFrame(), 12U);
  EXPECT_EQ(link_.framesBetween(10, 13, 1).size(), 2U);
  EXPECT_TRUE(link_.waitForTick(12, 0));
  EXPECT_FALSE(link_.waitForTick(13, 0));
  EXPECT_TRUE(link_.waitForFrame(12, 0));
  EXPECT_FALSE(link_.waitForFrame(13, 0));
  EXPECT_EQ(link_.stats().received, 3U);
  EXPECT_EQ(link_.stats().reordered, 1U);
  EXPECT_EQ(link_.stats().lost, 0U);
}

TEST_F(LinkStateTest, AFrameKnowsWhenItFirstCameAndWhenItsSampleWasTaken) {
  welcome(server_);
  clock_.advance(5'000'000);
  MotionPacket first = packet(20);
  first.frames[0] = frameOf(4, 18, 60'000'000, worldAt(35));  // predicted from the second sample before
  deliver(server_.seal(first));
  clock_.advance(1'000'000);
  MotionPacket second = packet(21);
  second.frames = first.frames;
  deliver(server_.seal(second));
  const auto frame = link_.nextFrame(0, 1, {0}, 0);
  EXPECT_EQ(frame->arrived, ClientTime{5'000'000});
  EXPECT_EQ(frame->sampled, ServerTime{18'000'000});
  EXPECT_EQ(frame->state, first.frames[0]);
}

// A hostile server may count as it likes.
TEST_F(LinkStateTest, AFrameOfASampleFromNowhereIsTakenAsItIs) {
  welcome(server_);
  MotionPacket odd = packet(20);
  odd.frames[0].sample.sequence = ~std::uint64_t{0};
  EXPECT_TRUE(deliver(server_.seal(odd)));
  odd = packet(~std::uint64_t{0} - 1, worldAt(30));
  odd.sample.server_time_ns = 21'000'000;
  odd.frames = {frameOf(30, 1, 60'000'000, worldAt(30))};
  EXPECT_TRUE(deliver(server_.seal(odd)));
  EXPECT_EQ(link_.newestFrame(), 30U);
}

TEST_F(LinkStateTest, WhatIsNotTheServersIsCountedByCauseAndChangesNothing) {
  EXPECT_FALSE(receive(10));  // before any welcome
  EXPECT_EQ(link_.stats().forged, 1U);
  welcome(server_);
  ServerEnd other(50);
  EXPECT_FALSE(deliver(other.seal(packet(10))));
  Bytes changed = server_.seal(packet(10));
  changed[40] ^= std::byte{1};
  EXPECT_FALSE(deliver(changed));
  DatagramSealer client(server_.keys.client_datagrams, ServerEnd::kClient);
  EXPECT_FALSE(deliver(sealed(client, bodyOf(ClockProbe{5})))) << "its own, sent back";
  EXPECT_EQ(link_.stats().forged, 4U);
  EXPECT_FALSE(deliver(Bytes(50)));
  EXPECT_FALSE(deliver(Bytes(kMaxDatagram + 1)));
  EXPECT_FALSE(deliver(sealed(server_.replies, bodyOf(ClockProbe{5})))) << "no server sends a probe";
  const Bytes once = server_.seal(packet(10));
  EXPECT_EQ(link_.stats().received, 0U);
  EXPECT_FALSE(link_.newest());
  EXPECT_TRUE(deliver(once));
  EXPECT_FALSE(deliver(once));
  EXPECT_EQ(link_.stats().replayed, 1U);
  EXPECT_EQ(link_.stats().rejected, 7U);
  EXPECT_EQ(link_.stats().received, 1U);
}

TEST_F(LinkStateTest, OnlyAnswersToOwnProbesMoveTheClock) {
  welcome(server_);
  clock_.advance(1'000'000);
  const ClockProbe probe = ask();
  EXPECT_EQ(probe, (ClockProbe{1'000'000, 1, MotionWay::Udp}));
  clock_.advance(100'000);
  const std::int64_t server = probe.t0_client_ns + 50'000 + 7'000'000'000;
  EXPECT_FALSE(deliver(server_.seal(ClockReply{probe.t0_client_ns + 1, server, server})));  // never asked
  EXPECT_FALSE(deliver(ServerEnd(50).seal(ClockReply{probe.t0_client_ns, server, server})));
  EXPECT_FALSE(link_.toServer({0}));
  EXPECT_TRUE(deliver(server_.seal(ClockReply{probe.t0_client_ns, server, server})));
  EXPECT_FALSE(deliver(server_.seal(ClockReply{probe.t0_client_ns, server, server})));  // a second time
  EXPECT_EQ(link_.toServer({0})->ns, 7'000'000'000);
  EXPECT_EQ(link_.toClient({7'000'000'000})->ns, 0);
  EXPECT_EQ(link_.stats().clock_offset_ns, 7'000'000'000);
  EXPECT_LT(link_.stats().clock_bound_ns, 60'000);
}

TEST_F(LinkStateTest, OverTcpProbesAndMotionAreTheSameWithoutSeals) {
  welcome(server_);
  const auto probe = std::get<ClockProbe>(DatagramCodec().decode(link_.tunnelledProbe().body, {}));
  EXPECT_EQ(probe, (ClockProbe{clock_.nowNs(), 1, MotionWay::Tcp}));
  EXPECT_EQ(link_.tunnelled({bodyOf(ClockReply{probe.t0_client_ns, 5, 5})}, {clock_.nowNs()}),
            LinkState::Heard::Reply);
  EXPECT_TRUE(link_.stats().clock_known);
  Tunnelled motion;
  server_.codec.encode(packet(10), server_.keyframe.world, motion.body);
  EXPECT_EQ(link_.tunnelled(motion, {clock_.nowNs()}), LinkState::Heard::Motion);
  EXPECT_EQ(link_.newest()->packet, packet(10));
  EXPECT_EQ(link_.tunnelled({Bytes(20, std::byte{0x55})}, {clock_.nowNs()}), LinkState::Heard::Nothing);
  link_.setWay(MotionWay::Tcp);
  EXPECT_EQ(link_.stats().way, MotionWay::Tcp);
}

// ---- Keyframes ----

TEST_F(LinkStateTest, MotionBeforeItsKeyframeIsCountedAndTheServers) {
  link_.welcomed(server_.session(), server_.keys);
  EXPECT_EQ(ask().keyframe, 0U);
  EXPECT_TRUE(receive(10));
  EXPECT_FALSE(link_.newest());
  EXPECT_EQ(link_.stats().without_keyframe, 1U);
  EXPECT_EQ(link_.stats().rejected, 0U);
  link_.take(server_.keyframe);
  EXPECT_EQ(ask().keyframe, 1U);
  EXPECT_TRUE(receive(11));
  EXPECT_EQ(link_.newest()->packet, packet(11));
  EXPECT_EQ(link_.stats().keyframes, 1U);
}

TEST_F(LinkStateTest, WhileANewKeyframeComesTheOldOneIsStillCountedFrom) {
  welcome(server_);
  WorldState moved = worldAt(3000);
  moved.movables[1].x_nm = 9;
  const Keyframe second{2, moved};
  link_.take(second);
  EXPECT_EQ(ask().keyframe, 2U);
  EXPECT_TRUE(receive(10));
  EXPECT_EQ(link_.newest()->packet, packet(10));
  server_.keyframe = second;
  MotionPacket next = packet(11);
  next.keyframe = 2;
  EXPECT_TRUE(deliver(server_.seal(next)));
  EXPECT_EQ(link_.newest()->packet, next);
}

// What a spoilt keyframe makes does not have its hash; said again it is named and all is well.
TEST_F(LinkStateTest, ASpoiltKeyframeIsFoundNamedAndMadeGood) {
  link_.welcomed(server_.session(), server_.keys);
  Keyframe spoilt = server_.keyframe;
  spoilt.world.movables[1].x_nm ^= 1 << 20;
  spoilt.world.doors[0] = 9;
  link_.take(spoilt);
  EXPECT_TRUE(receive(10));
  EXPECT_FALSE(hashHolds(link_.nextFrame(0, 1, {0}, 0)->state));
  EXPECT_FALSE(hashHolds(link_.newest()->packet));
  EXPECT_EQ(link_.stats().differing_field, "");

  EXPECT_FALSE(link_.takeKeyframeWish());
  link_.requestKeyframe();
  link_.requestKeyframe();
  EXPECT_TRUE(link_.takeKeyframeWish());
  EXPECT_FALSE(link_.takeKeyframeWish()) << "asked for once";
  link_.take(server_.keyframe);
  EXPECT_EQ(link_.stats().differing_field, "movable x") << "the first that differs";
  EXPECT_TRUE(receive(11));
  EXPECT_EQ(link_.newest()->packet, packet(11));
  EXPECT_TRUE(hashHolds(link_.nextFrame(10, 1, {0}, 0)->state));
  link_.take(server_.keyframe);
  EXPECT_EQ(link_.stats().differing_field, "movable x");
  EXPECT_EQ(link_.stats().keyframes, 3U);
}

// ---- Sessions ----

TEST_F(LinkStateTest, AnotherSessionBeginsAfresh) {
  welcome(server_);
  const ClockProbe probe = ask();
  deliver(server_.seal(ClockReply{probe.t0_client_ns, 10, 10}));
  receive(500);
  link_.keepFirstFrom({400});
  receive(501);
  link_.reportFrame({.number = 500});
  ServerEnd other(50);
  link_.welcomed(other.session(), other.keys);
  EXPECT_FALSE(link_.newest());
  EXPECT_EQ(link_.newestFrame(), 0U);
  EXPECT_FALSE(link_.firstFrom(400));
  EXPECT_FALSE(link_.toServer({0}));
  EXPECT_TRUE(link_.takeReport().frames.empty());
  EXPECT_FALSE(receive(502)) << "the old one's";
  EXPECT_TRUE(deliver(other.seal(packet(1))));
  EXPECT_EQ(link_.stats().without_keyframe, 1U) << "and the old one's keyframe is not its";
  link_.take(other.keyframe);
  EXPECT_TRUE(deliver(other.seal(packet(2))));  // its numbers begin at one
  EXPECT_EQ(link_.newest()->packet.sample.sequence, 2U);
  EXPECT_EQ(link_.newestFrame(), 2U);
  EXPECT_EQ(link_.stats().connections, 2U);
}

TEST_F(LinkStateTest, TheSameSessionGoesOnAfterAReconnect) {
  welcome(server_);
  const ClockProbe probe = ask();
  const Bytes old = server_.seal(packet(500));
  deliver(old);
  const Bytes late_reply = server_.seal(ClockReply{probe.t0_client_ns, 10, 10});
  link_.disconnected("it fell silent");
  EXPECT_FALSE(link_.stats().connected);
  EXPECT_TRUE(link_.newest());  // the last pose is held
  server_.reconnect(80);
  link_.welcomed(server_.session(), server_.keys);
  EXPECT_FALSE(deliver(late_reply)) << "of a connection that is no more";
  EXPECT_FALSE(deliver(old)) << "what was here before stays known";
  EXPECT_EQ(link_.stats().replayed, 1U);
  receive(900);
  EXPECT_EQ(link_.stats().lost, 0U);  // what was sent meanwhile was not sent to us
  EXPECT_EQ(link_.newest()->packet.sample.sequence, 900U);
}

TEST_F(LinkStateTest, ReportsCarryTheNewestFramesOnce) {
  welcome(server_);
  for (std::uint64_t n = 1; n <= kMaxReportFrames + 500; ++n) link_.reportFrame({.number = n});
  const ClientReport report = link_.takeReport();
  ASSERT_EQ(report.frames.size(), kMaxReportFrames);
  EXPECT_EQ(report.frames.front().number, 501U);
  EXPECT_TRUE(isValid(report));
  EXPECT_TRUE(link_.takeReport().frames.empty());
}

}  // namespace
}  // namespace coherency
