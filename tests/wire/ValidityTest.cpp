#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/FixedPoint.h"
#include "common/wire/Validity.h"
#include "tests/wire/GoldenMessages.h"
#include "tests/wire/MessageGenerators.h"

namespace coherency {
namespace {

MotionSample goodSample() {
  MotionSample sample;
  sample.sequence = 10;
  sample.valid = kAllDofs;
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const DofInfo& dof = dofTable()[i];
    sample.units[i] = unitsFromSi(dof.kind, (dof.min + dof.max) / 2);
  }
  return sample;
}

SessionConfig goodSession() {
  SessionConfig session;
  session.session_id = session.client_id = 1;
  session.scene.name = "laboratory";
  session.udp_port = kDefaultPort;
  return session;
}

TEST(Validity, ASampleNeedsANumberATimeAndKnownDofs) {
  EXPECT_TRUE(isValid(goodSample()));
  MotionSample sample = goodSample();
  sample.sequence = 0;
  EXPECT_FALSE(isValid(sample));
  sample = goodSample();
  sample.valid = kAllDofs + 1;
  EXPECT_FALSE(isValid(sample));
  sample = goodSample();
  sample.server_time_ns = -1;
  EXPECT_FALSE(isValid(sample));
  sample.server_time_ns = kMaxTimeNs + 1;
  EXPECT_FALSE(isValid(sample));
}

TEST(Validity, AMeasuredDofMustBeInItsRangeAHeldOneNeedNot) {
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const DofInfo& dof = dofTable()[i];
    for (const double border : {dof.min, dof.max}) {
      MotionSample sample = goodSample();
      sample.units[i] = unitsFromSi(dof.kind, border);
      EXPECT_TRUE(isValid(sample)) << dof.name << " at its border";
    }
    const bool whole_turn = dof.kind == DofKind::Angle && dof.max - dof.min >= kTurn - 1e-9;
    if (whole_turn) continue;
    for (const double outside : {dof.min - 1e-3, dof.max + 1e-3}) {
      MotionSample sample = goodSample();
      sample.units[i] = unitsFromSi(dof.kind, outside);
      EXPECT_FALSE(isValid(sample)) << dof.name << " = " << outside;
      sample.valid &= ~mask(dofAt(i));
      EXPECT_TRUE(isValid(sample)) << dof.name << " held at " << outside;
    }
  }
}

MotionPacket goodPacket() {
  MotionPacket packet;
  packet.keyframe = 1;
  packet.sample = goodSample();
  return packet;
}

TEST(Validity, APacketNamesItsKeyframe) {
  MotionPacket packet = goodPacket();
  EXPECT_TRUE(isValid(packet));
  packet.keyframe = 0;
  EXPECT_FALSE(isValid(packet));
}

TEST(Validity, PreviousSamplesComeInFallingOrder) {
  MotionPacket packet = goodPacket();
  MotionSample earlier = goodSample();
  earlier.sequence = 9;
  packet.previous = {earlier};
  EXPECT_TRUE(isValid(packet));
  packet.previous = {earlier, earlier};
  EXPECT_FALSE(isValid(packet));
  packet.previous = {packet.sample};
  EXPECT_FALSE(isValid(packet));
  packet.previous.assign(kMaxPrevious + 1, packet.sample);
  for (std::size_t i = 0; i <= kMaxPrevious; ++i) packet.previous[i].sequence -= i + 1;
  EXPECT_FALSE(isValid(packet));
  packet.previous.pop_back();
  EXPECT_TRUE(isValid(packet));
}

TEST(Validity, FramesComeInFallingOrder) {
  MotionPacket packet = goodPacket();
  const auto numbered = [](std::uint64_t number) { return FrameState{number, goodSample(), {}, 0}; };
  packet.frames = {numbered(12), numbered(11), numbered(3)};
  static_assert(kMaxFrames == 3);
  EXPECT_TRUE(isValid(packet));
  packet.frames[2].number = 11;
  EXPECT_FALSE(isValid(packet));
  packet.frames = {numbered(1), numbered(2)};
  EXPECT_FALSE(isValid(packet));
  packet.frames = {numbered(5), numbered(4), numbered(3), numbered(2)};
  EXPECT_FALSE(isValid(packet));
}

TEST(Validity, AFrameHasAGoodSampleAndWorld) {
  MotionPacket packet = goodPacket();
  packet.frames = {{1, goodSample(), {}, 0}};
  packet.frames[0].sample.sequence = 0;
  EXPECT_FALSE(isValid(packet));
  packet.frames = {{1, goodSample(), {}, 0}};
  packet.frames[0].world.doors.push_back(-1);
  EXPECT_FALSE(isValid(packet));
}

TEST(Validity, AKeyframeHasANumberAndAWorldThatCanBe) {
  EXPECT_TRUE(isValid(Keyframe{1, {}}));
  EXPECT_FALSE(isValid(Keyframe{0, {}}));
  Keyframe keyframe{1, {}};
  keyframe.world.closed_hands = 4;
  EXPECT_FALSE(isValid(keyframe));
}

TEST(Validity, ClocksSayTimesThatCanBe) {
  EXPECT_TRUE(isValid(ClockProbe{kMaxTimeNs, ~0U, MotionWay::Tcp}));
  EXPECT_FALSE(isValid(ClockProbe{kMaxTimeNs + 1, 0, MotionWay::Udp}));
  EXPECT_FALSE(isValid(ClockProbe{-1, 0, MotionWay::Udp}));
  EXPECT_TRUE(isValid(ClockReply{1, 2, 2}));
  EXPECT_FALSE(isValid(ClockReply{1, 3, 2})) << "answered before it was asked";
  EXPECT_FALSE(isValid(ClockReply{-1, 2, 3}));
}

TEST(Validity, TheBaseStaysWithinReach) {
  WorldState world;
  world.robot.base.z_nm = -kWorldLimitNm;
  EXPECT_TRUE(isValid(world));
  world.robot.base.z_nm = std::numeric_limits<std::int64_t>::min();
  EXPECT_FALSE(isValid(world));
}

TEST(Validity, ASessionNamesAPossibleSceneRigAndPeriod) {
  EXPECT_TRUE(isValid(goodSession()));
  for (const std::string& scene : {std::string(), std::string("../etc/passwd"), std::string("a b"),
                                   std::string("\x1b[2J"), std::string(kMaxText + 1, 'a')}) {
    SessionConfig session = goodSession();
    session.scene.name = scene;
    EXPECT_FALSE(isValid(session)) << scene;
  }
  for (const std::int64_t period : {std::int64_t{0}, std::int64_t{-1}, kMinPeriodNs - 1, kMaxPeriodNs + 1}) {
    SessionConfig session = goodSession();
    session.period_ns = period;
    EXPECT_FALSE(isValid(session)) << period;
  }
  for (const RigField& field : rigFields()) {
    for (const double wrong : {std::nan(""), HUGE_VAL, -HUGE_VAL, field.max * 2 + 1, field.min - 1}) {
      SessionConfig session = goodSession();
      session.rig.*(field.value) = wrong;
      EXPECT_FALSE(isValid(session)) << field.name << " = " << wrong;
    }
  }
}

TEST(Validity, ASessionKnowsItsClientAndItsPort) {
  const auto valid = [](auto change) {
    SessionConfig session = goodSession();
    change(session);
    return isValid(session);
  };
  EXPECT_FALSE(valid([](auto& s) { s.session_id = 0; }));
  EXPECT_FALSE(valid([](auto& s) { s.client_id = 0; })) << "channel 0 is everybody's";
  EXPECT_FALSE(valid([](auto& s) { s.udp_port = 0; }));
  EXPECT_TRUE(valid([](auto& s) { s.frame_ns = kMinFrameNs; }));
  EXPECT_FALSE(valid([](auto& s) { s.frame_ns = kMinFrameNs - 1; }));
  EXPECT_FALSE(valid([](auto& s) { s.frame_ns = kMaxPeriodNs + 1; }));
  EXPECT_FALSE(valid([](auto& s) { s.frame_ns = -16'000'000; }));
}

TEST(Validity, AGroupIsAMulticastAddressAndAPort) {
  const auto valid = [](const std::string& address, std::uint16_t port = 7432) {
    SessionConfig session = goodSession();
    session.multicast = {address, port};
    return isValid(session);
  };
  for (const char* const group : {"224.0.0.0", "239.7.43.0", "239.255.255.255"})
    EXPECT_TRUE(valid(group)) << group;
  for (const char* const other : {"",           "223.255.255.255", "240.0.0.0",   "127.0.0.1",
                                  "239.1.2",    "239.1.2.256",     "239.1.2.3.4", "239.1.2.3 ",
                                  " 239.1.2.3", "239. 1.2.3",      "239.+1.2.3",  "239.-1.2.3",
                                  "239.-0.2.3", "239.01.2.3",      "239..2.3",    "239.1.2.",
                                  "239.1.2.3.", "239.1.2.x",       "ff02::1",     "a.multicast.group"})
    EXPECT_FALSE(valid(other)) << other;
  EXPECT_FALSE(valid(std::string("239.1.2.3\0x", 11)));
  EXPECT_FALSE(valid("239.7.43.0", 0));
}

TEST(Validity, AFormNamesKnownDofsThatStandWithinTheirRanges) {
  SampleForm form;
  EXPECT_TRUE(isValid(form));
  form.dofs = kAllDofs + 1;
  EXPECT_FALSE(isValid(form));
  form.dofs = 0;
  EXPECT_TRUE(isValid(form));
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const DofInfo& dof = dofTable()[i];
    if (dof.kind == DofKind::Angle && dof.max - dof.min >= kTurn - 1e-9) continue;
    form = {};
    form.still[i] = unitsFromSi(dof.kind, dof.max + 1e-3);
    EXPECT_FALSE(isValid(form)) << dof.name;
    form.still[i] = unitsFromSi(dof.kind, dof.max);
    EXPECT_TRUE(isValid(form)) << dof.name;
  }
}

TEST(Validity, ASceneNamesPossibleObjects) {
  const auto valid = [](auto change) {
    SceneDescription scene;
    scene.name = "laboratory";
    scene.robot.emplace();
    scene.objects.push_back({"block", "red block", {1, 2, 3, 4}, "#ff0000", 0});
    change(scene);
    return isValid(scene);
  };
  EXPECT_TRUE(valid([](auto&) {}));
  EXPECT_FALSE(valid([](auto& s) { s.objects[0].name = "\x1b[2J"; }));
  EXPECT_FALSE(valid([](auto& s) { s.objects[0].kind = "two\nlines"; }));
  EXPECT_TRUE(valid([](auto& s) { s.objects[0].kind = std::string(kMaxKind, 'k'); }));
  EXPECT_FALSE(valid([](auto& s) { s.objects[0].kind = std::string(kMaxKind + 1, 'k'); }));
  EXPECT_TRUE(valid([](auto& s) { s.objects[0].colour = ""; }));
  EXPECT_FALSE(valid([](auto& s) { s.objects[0].colour = "#ff00001"; }));
  EXPECT_FALSE(valid([](auto& s) { s.objects[0].colour = "\x1b[2J"; }));
  EXPECT_FALSE(valid([](auto& s) { s.objects[0].place.y_nm = kWorldLimitNm + 1; }));
  EXPECT_FALSE(valid([](auto& s) { s.objects[0].count = -1; }));
  EXPECT_TRUE(valid([](auto& s) { s.objects[0].count = kMaxSceneParts; }));
  EXPECT_FALSE(valid([](auto& s) { s.objects[0].count = kMaxSceneParts + 1; }));
  EXPECT_FALSE(valid([](auto& s) {
    s.objects[0].count = kMaxSceneParts;
    s.objects.push_back({"grid", "another", {}, "", 1});
  })) << "many small ones cost as much as a large one";
  EXPECT_FALSE(valid([](auto& s) {
    s.objects.assign(kMaxSceneObjects, {"grid", "g", {}, "", std::numeric_limits<std::int32_t>::max()});
  }));
  EXPECT_FALSE(valid([](auto& s) { s.objects.resize(kMaxSceneObjects + 1, s.objects[0]); }));
  EXPECT_FALSE(valid([](auto& s) { s.workplace.x_nm = -kWorldLimitNm - 1; }));
  EXPECT_FALSE(valid([](auto& s) { s.robot->start.z_nm = kWorldLimitNm + 1; }));
}

TEST(Validity, TextsAreSafeToShow) {
  EXPECT_TRUE(isPlainText("server full (4 clients)"));
  EXPECT_FALSE(isPlainText("\x1b[31mred"));
  EXPECT_FALSE(isPlainText("two\nlines"));
  EXPECT_FALSE(isPlainText("caf\xc3\xa9"));
  EXPECT_EQ(plainText("a\x1b[b\n"), "a?[b?");
}

RC_GTEST_PROP(Validity, PlainTextIsPlain, (const std::string& any)) {
  RC_ASSERT(isPlainText(plainText(any)));
}

TEST(Validity, AHelloIsOfThisMajor) {
  EXPECT_TRUE(isValid(Hello{kWireMajor, ~0U, {}, false}));
  EXPECT_FALSE(isValid(Hello{kWireMajor + 1, 0, {}, false}));
  EXPECT_FALSE(isValid(Hello{kWireMajor - 1, 0, {}, false}));
}

TEST(Validity, OneJoinsWithAnEyeAndAName) {
  for (const char* const eye : {"left", "right", "both", "mono"}) EXPECT_TRUE(isValid(Join{eye, "software"}));
  for (const char* const eye : {"", "third", "Left", "left "}) EXPECT_FALSE(isValid(Join{eye, "software"}));
  EXPECT_FALSE(isValid(Join{"left", "\x1b[2J"}));
  EXPECT_FALSE(isValid(Join{"left", std::string(kMaxText + 1, 'a')}));
}

TEST(Validity, AReportIsOfFramesThatCanHaveBeenDrawn) {
  const FrameReport good{1, Fate::Mismatch, 1, 1, kMaxTimeNs, kMaxTimeNs, kMaxTimeNs};
  ClientReport report;
  report.frames.assign(kMaxReportFrames, good);
  EXPECT_TRUE(isValid(report));
  report.frames.push_back(good);
  EXPECT_FALSE(isValid(report));
  for (std::int64_t FrameReport::*const time :
       {&FrameReport::presented_server_ns, &FrameReport::arrived_server_ns, &FrameReport::draw_ns}) {
    for (const std::int64_t wrong : {std::int64_t{-1}, kMaxTimeNs + 1}) {
      report.frames = {good};
      report.frames[0].*time = wrong;
      EXPECT_FALSE(isValid(report));
    }
  }
  report.frames = {good};
  report.frames[0].fate = static_cast<Fate>(4);
  EXPECT_FALSE(isValid(report));
}

TEST(Validity, WhatIsTunnelledIsADatagramsBody) {
  EXPECT_FALSE(isValid(Tunnelled{}));
  EXPECT_TRUE(isValid(Tunnelled{sealing::Bytes(1)}));
  EXPECT_TRUE(isValid(Tunnelled{sealing::Bytes(kMaxDatagramBody)}));
  EXPECT_FALSE(isValid(Tunnelled{sealing::Bytes(kMaxDatagramBody + 1)}));
}

TEST(Validity, ModesAndCausesAreThoseThereAre) {
  EXPECT_TRUE(isValid(ModeRequest{Mode::Robot}));
  EXPECT_FALSE(isValid(ModeRequest{static_cast<Mode>(2)}));
  EXPECT_TRUE(isValid(Goodbye{"", GoodbyeCause::Key}));
  EXPECT_FALSE(isValid(Goodbye{"", static_cast<GoodbyeCause>(5)}));
  EXPECT_FALSE(isValid(Goodbye{"two\nlines", GoodbyeCause::Leaving}));
}

TEST(Validity, AnAnnouncementNamesAMachineASceneAndAPort) {
  EXPECT_TRUE(isValid(golden::announcement()));
  const auto valid = [](auto change) {
    Announcement announcement = golden::announcement();
    change(announcement);
    return isValid(announcement);
  };
  EXPECT_TRUE(valid([](auto& a) { a.major = 99; }));
  EXPECT_FALSE(valid([](auto& a) { a.host = "\x1b[2J"; }));
  EXPECT_FALSE(valid([](auto& a) { a.scene = ""; }));
  EXPECT_FALSE(valid([](auto& a) { a.port = 0; }));
}

RC_GTEST_PROP(Validity, TheHashHoldsUntilSomethingChanges, ()) {
  MotionPacket packet = arbitrary::motion(arbitrary::keyframe(), arbitrary::form());
  packet.hash = stateHash(packet.world, packet.sample);
  RC_ASSERT(hashHolds(packet));
  packet.sample.units[*rc::gen::inRange<std::size_t>(0, kDofCount)] ^= 1 << *rc::gen::inRange(0, 31);
  RC_ASSERT(!hashHolds(packet));
}

}  // namespace
}  // namespace coherency
