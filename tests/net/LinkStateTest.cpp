#include <stdexcept>

#include <gtest/gtest.h>

#include "common/wire/Validity.h"
#include "render_client/receive/LinkState.h"
#include "tests/net/Support.h"

namespace coherency {
namespace {

using namespace testing;

class LinkStateTest : public ::testing::Test {
 protected:
  SessionConfig session(std::uint64_t id) {
    SessionConfig s = laboratory();
    s.session_id = id;
    s.client_id = 3;
    s.client_token = 4;
    return s;
  }
  bool receive(std::uint64_t session_id, std::uint64_t sequence) {
    return link_.datagram(datagram(packet(session_id, sequence)), {clock_.nowNs()});
  }
  bool reply(const ClockReply& reply) { return link_.datagram(datagram(reply), {clock_.nowNs()}); }

  ManualClock clock_;
  LinkState link_{{"server.example", 7430, "left"}, clock_};
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

TEST_F(LinkStateTest, AnotherVersionIsFinalAFullServerIsNot) {
  link_.refused({"3 clients already", GoodbyeCause::Full});
  EXPECT_NE(errorOf(link_).find("within"), std::string::npos) << errorOf(link_);
  EXPECT_NE(errorOf(link_).find("3 clients already"), std::string::npos) << errorOf(link_);
  link_.refused({"speaks version 2.0", GoodbyeCause::Version});
  EXPECT_NE(errorOf(link_).find("refused: speaks version 2.0"), std::string::npos) << errorOf(link_);
  EXPECT_EQ(errorOf(link_).find("within"), std::string::npos) << errorOf(link_);
}

TEST_F(LinkStateTest, TheNewestWinsAndTicksAreFound) {
  link_.welcomed(session(1));
  EXPECT_FALSE(link_.newest());
  EXPECT_TRUE(receive(1, 10));
  EXPECT_TRUE(receive(1, 12));
  EXPECT_TRUE(receive(1, 11));
  EXPECT_EQ(link_.newest()->packet.sample.sequence, 12U);
  EXPECT_EQ(link_.atTick(11)->packet.sample.sequence, 11U);
  EXPECT_FALSE(link_.atTick(9));
  EXPECT_TRUE(link_.waitForTick(12, 0));
  EXPECT_FALSE(link_.waitForTick(13, 0));
  EXPECT_EQ(link_.stats().received, 3U);
  EXPECT_EQ(link_.stats().reordered, 1U);
  EXPECT_EQ(link_.stats().lost, 0U);
}

TEST_F(LinkStateTest, OnlyTheLastTicksAreKept) {
  link_.welcomed(session(1));
  const std::uint64_t last = 3 * kRecentPackets + 8;
  for (std::uint64_t s = 1; s <= last; ++s) receive(1, s);
  receive(1, kRecentPackets);  // much too late
  EXPECT_TRUE(link_.atTick(last));
  EXPECT_TRUE(link_.atTick(last - kRecentPackets + 1));
  EXPECT_FALSE(link_.atTick(last - kRecentPackets));
  EXPECT_FALSE(link_.atTick(kRecentPackets));
}

TEST_F(LinkStateTest, TheFirstPacketFromATickOnIsKeptUntilAskedForHoweverLate) {
  link_.welcomed(session(1));
  link_.keepFirstFrom({7, 9, 1'000'000});
  const auto kept = [&](std::uint64_t tick) { return link_.firstFrom(tick)->packet.world.tick; };
  const std::uint64_t last = 5 * kRecentPackets;
  for (std::uint64_t s = 1; s <= last; ++s)
    if (s < 9 || s > 11) receive(1, s);  // a server that was held up leaves ticks out
  EXPECT_EQ(kept(7), 7U);
  EXPECT_EQ(kept(9), 12U);
  EXPECT_FALSE(link_.firstFrom(1'000'000));
  EXPECT_FALSE(link_.firstFrom(8)) << "was not to be kept";
  receive(1, 10);  // or it only came in another order
  EXPECT_EQ(kept(9), 10U);
  link_.keepFirstFrom({9});
  EXPECT_FALSE(link_.firstFrom(7));
  EXPECT_EQ(kept(9), 10U);
  link_.welcomed(session(2));
  EXPECT_FALSE(link_.firstFrom(9));
}

TEST_F(LinkStateTest, OtherSessionsAndNoiseAreRejected) {
  EXPECT_FALSE(receive(1, 10));  // before any welcome
  link_.welcomed(session(1));
  EXPECT_FALSE(receive(2, 10));
  EXPECT_FALSE(link_.datagram(Bytes(50), {0}));
  EXPECT_FALSE(link_.datagram(datagram(ClockProbe{1, 3, 4, 5}), {0}));
  EXPECT_EQ(link_.stats().rejected, 4U);
  EXPECT_EQ(link_.stats().received, 0U);
  EXPECT_FALSE(link_.newest());
}

TEST_F(LinkStateTest, OnlyAnswersToOwnProbesMoveTheClock) {
  link_.welcomed(session(1));
  clock_.advance(1'000'000);
  const ClockProbe probe = link_.probe();
  EXPECT_EQ(probe.client_token, 4U);
  clock_.advance(100'000);
  const std::int64_t server = probe.t0_client_ns + 50'000 + 7'000'000'000;
  EXPECT_FALSE(reply({1, probe.t0_client_ns + 1, server, server}));  // never asked
  EXPECT_FALSE(reply({2, probe.t0_client_ns, server, server}));      // of another session
  EXPECT_FALSE(link_.toServer({0}));
  EXPECT_TRUE(reply({1, probe.t0_client_ns, server, server}));
  EXPECT_FALSE(reply({1, probe.t0_client_ns, server, server}));  // a second time
  EXPECT_EQ(link_.toServer({0})->ns, 7'000'000'000);
  EXPECT_EQ(link_.stats().clock_offset_ns, 7'000'000'000);
  EXPECT_LT(link_.stats().clock_bound_ns, 60'000);
}

TEST_F(LinkStateTest, AnotherSessionBeginsAfresh) {
  link_.welcomed(session(1));
  const ClockProbe probe = link_.probe();
  reply({1, probe.t0_client_ns, 10, 10});
  receive(1, 500);
  link_.reportFrame({500, 1, 2});
  link_.welcomed(session(2));
  EXPECT_FALSE(link_.newest());
  EXPECT_FALSE(link_.atTick(500));
  EXPECT_FALSE(link_.toServer({0}));
  EXPECT_TRUE(link_.takeReport().frames.empty());
  EXPECT_TRUE(receive(2, 1));  // its numbers begin at one
  EXPECT_EQ(link_.newest()->packet.sample.sequence, 1U);
  EXPECT_EQ(link_.stats().connections, 2U);
}

TEST_F(LinkStateTest, TheSameSessionGoesOnAfterAReconnect) {
  link_.welcomed(session(1));
  receive(1, 500);
  link_.disconnected("it fell silent");
  EXPECT_FALSE(link_.stats().connected);
  EXPECT_TRUE(link_.newest());  // the last pose is held
  link_.welcomed(session(1));
  receive(1, 900);
  EXPECT_EQ(link_.stats().lost, 0U);  // what was sent meanwhile was not sent to us
}

TEST_F(LinkStateTest, ReportsCarryTheNewestThousandFramesOnce) {
  link_.welcomed(session(1));
  for (std::uint64_t s = 1; s <= kMaxReportFrames + 500; ++s) link_.reportFrame({s, s, 0});
  const ClientReport report = link_.takeReport();
  ASSERT_EQ(report.frames.size(), kMaxReportFrames);
  EXPECT_EQ(report.frames.front().sequence, 501U);
  EXPECT_TRUE(isValid(report));
  EXPECT_TRUE(link_.takeReport().frames.empty());
}

}  // namespace
}  // namespace coherency
