#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/Validity.h"
#include "tests/wire/Generators.h"

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

TEST(Validity, PreviousSamplesComeInFallingOrder) {
  MotionPacket packet;
  packet.session_id = 1;
  packet.sample = goodSample();
  MotionSample earlier = goodSample();
  earlier.sequence = 9;
  packet.previous = {earlier};
  EXPECT_TRUE(isValid(packet));
  packet.previous = {earlier, earlier};
  EXPECT_FALSE(isValid(packet));
  packet.previous = {packet.sample};
  EXPECT_FALSE(isValid(packet));
  packet.previous.clear();
  packet.session_id = 0;
  EXPECT_FALSE(isValid(packet));
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

TEST(Validity, AHelloOfAnotherVersionIsHeardWhateverItSays) {
  EXPECT_FALSE(isValid(Hello{kWireMajor, 0, "third", ""}));
  EXPECT_TRUE(isValid(Hello{kWireMajor + 1, 0, "third", "\x01"}));
}

RC_GTEST_PROP(Validity, TheHashHoldsUntilSomethingChanges, ()) {
  MotionPacket packet = arbitrary::motion();
  packet.hash = stateHash(packet.world, packet.sample);
  RC_ASSERT(hashHolds(packet));
  packet.sample.units[*rc::gen::inRange<std::size_t>(0, kDofCount)] ^= 1 << *rc::gen::inRange(0, 31);
  RC_ASSERT(!hashHolds(packet));
}

}  // namespace
}  // namespace coherency
