#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "common/body/Posture.h"
#include "common/math/FixedPoint.h"
#include "motion_server/authority/Authority.h"
#include "motion_server/device/SimulatedMaster.h"

namespace coherency {
namespace {

constexpr std::int64_t kPeriod = 1'000'000;

OperatorTask someTask() {
  OperatorTask task;
  task.targets = {{0.15, 0.83, -0.55}, {0.30, 0.83, -0.45}, {-0.10, 0.83, -0.70}};
  task.start.x_nm = 600'000'000;
  task.start.z_nm = 2'500'000'000;
  task.start.heading_units = unitsFromRadians(0.4);
  return task;
}

/// What the operator did, millisecond by millisecond, with the world answering to the stick.
struct Session {
  std::vector<MasterReading> readings;
  std::vector<WorldState> worlds;
  std::vector<Coord3> palms;  // world
};

class Recorder final : public Master {
 public:
  Recorder(Master& master, Session& session) : master_(master), session_(session) {}
  std::string name() const override { return master_.name(); }
  std::optional<MasterReading> read(std::int64_t elapsed_ns, const WorldState& world) override {
    const auto reading = master_.read(elapsed_ns, world);
    session_.readings.push_back(*reading);
    return reading;
  }

 private:
  Master& master_;
  Session& session_;
};

Session perform(const OperatorTask& task, std::uint64_t seed, int milliseconds) {
  const Rig rig;
  Session session;
  SimulatedMaster simulated(task, rig, seed);
  Recorder recorder(simulated, session);
  AuthorityConfig config;
  config.start = task.start;
  Authority authority(config, rig, recorder);
  const ArmKinematics arm(rig);
  for (int k = 1; k <= milliseconds; ++k) {
    const auto result = authority.sample(k * kPeriod, 0, 1);
    session.worlds.push_back(result->world);
    const Posture p = posture(rig, arm, result->sample);
    session.palms.push_back(transform(result->world.base).point(p.t_body_shoulder.point(p.right_arm.palm)));
  }
  for (const std::uint64_t refused : authority.refused()) EXPECT_EQ(refused, 0u);
  return session;
}

/// Fastest a DOF may go and how hard it may accelerate, in SI: people's, or the device's for stick and hand.
struct Bounds {
  double speed;
  double acceleration;
};
Bounds boundsOf(std::size_t i) {
  if (i < index(Dof::HeadYaw)) return {1.6, 12.0};
  if (i < index(Dof::ShoulderFlexion)) return {5.0, 30.0};
  if (i < index(Dof::Grip)) return {8.0, 100.0};
  return {8.0, 130.0};
}

void expectContinuous(const Session& s, std::uint64_t seed) {
  for (std::size_t i = 0; i < kDofCount; ++i) {
    double fastest = 0.0, hardest = 0.0;
    for (std::size_t k = 2; k < s.readings.size(); ++k) {
      const double now = s.readings[k].si[i], before = s.readings[k - 1].si[i],
                   two_before = s.readings[k - 2].si[i];
      fastest = std::max(fastest, std::abs(now - before) * 1e3);
      hardest = std::max(hardest, std::abs(now - 2 * before + two_before) * 1e6);
    }
    EXPECT_LT(fastest, boundsOf(i).speed) << dofTable()[i].name << " seed " << seed;
    EXPECT_LT(hardest, boundsOf(i).acceleration) << dofTable()[i].name << " seed " << seed;
    EXPECT_GT(fastest, 0.01) << dofTable()[i].name << " never moved, seed " << seed;
  }
}

double farthest(const Session& s, std::size_t from, Dof dof) {
  double most = 0.0;
  for (std::size_t k = from; k < s.readings.size(); ++k) most = std::max(most, s.readings[k].si[index(dof)]);
  return most;
}

TEST(SimulatedMaster, EveryDofMovesContinuously) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) expectContinuous(perform(someTask(), seed, 60'000), seed);
}

TEST(SimulatedMaster, DrivesToTheWorkplaceAndPutsItsHandToEveryTarget) {
  const OperatorTask task = someTask();
  const Session s = perform(task, 1, 120'000);
  double nearest_base = 9.0;
  for (const WorldState& w : s.worlds) {
    nearest_base = std::min(nearest_base,
                            std::hypot(metresFromNanometres(w.base.x_nm), metresFromNanometres(w.base.z_nm)));
  }
  EXPECT_LT(nearest_base, 0.03);
  for (const Coord3& target : task.targets) {
    double nearest = 9.0, grip_there = 0.0;
    for (std::size_t k = 0; k < s.palms.size(); ++k) {
      const double distance = norm(s.palms[k] - target);
      nearest = std::min(nearest, distance);
      if (distance < 0.015) grip_there = std::max(grip_there, s.readings[k].si[index(Dof::Grip)]);
    }
    EXPECT_LT(nearest, 0.01) << "target at x " << target.x;
    EXPECT_GT(grip_there, 0.6) << "target at x " << target.x;
  }
}

TEST(SimulatedMaster, TheHeadTurnsBeforeTheHandMoves) {
  // The base is already at work: the first reach follows the first look at a target.
  OperatorTask task = someTask();
  task.start = task.workplace;
  const Session s = perform(task, 4, 30'000);
  std::size_t hand = 0;
  while (hand < s.palms.size() && norm(s.palms[hand] - s.palms[0]) < 0.03) ++hand;
  ASSERT_LT(hand, s.palms.size());
  ASSERT_GT(hand, 250u);
  // In the quarter second before, the head was already under way.
  double turned = 0.0;
  for (const Dof dof : {Dof::HeadYaw, Dof::HeadPitch}) {
    turned =
        std::max(turned, std::abs(s.readings[hand].si[index(dof)] - s.readings[hand - 250].si[index(dof)]));
  }
  EXPECT_GT(turned, 0.05);
}

TEST(SimulatedMaster, LeansForFarTargets) {
  const auto leanFor = [](double z) {
    OperatorTask task;
    task.targets = {{0.1, 0.78, z}};
    const Session s = perform(task, 5, 20'000);
    double lowest = 9.0;
    for (const MasterReading& r : s.readings) lowest = std::min(lowest, r.si[index(Dof::HeadZ)]);
    return -lowest;
  };
  EXPECT_GT(leanFor(-0.85), leanFor(-0.45) + 0.15);
}

TEST(SimulatedMaster, TheHeadSitsOnTheNeckOfAnUpperBodyOfFixedLength) {
  const Rig rig;
  const ArmKinematics arm(rig);
  const Session s = perform(someTask(), 6, 40'000);
  SampleGate gate(neutralPosture(rig));
  for (std::size_t k = 0; k < s.readings.size(); k += 50) {
    EXPECT_NEAR(posture(rig, arm, gate.admit(s.readings[k], 1, 0)).trunk_stretch, 1.0, 1e-4);
  }
}

TEST(SimulatedMaster, SameSeedSameMotionOtherSeedOther) {
  const Session a = perform(someTask(), 8, 15'000);
  const Session b = perform(someTask(), 8, 15'000);
  const Session c = perform(someTask(), 9, 15'000);
  bool differs = false;
  for (std::size_t k = 0; k < a.readings.size(); ++k) {
    ASSERT_EQ(a.readings[k].si, b.readings[k].si) << k;
    differs = differs || a.readings[k].si != c.readings[k].si;
  }
  EXPECT_TRUE(differs);
  EXPECT_EQ(a.worlds.back(), b.worlds.back());
}

TEST(SimulatedMaster, GoesOnWhenThereIsNothingToDoOrToReach) {
  OperatorTask idle;
  const Session nothing = perform(idle, 10, 20'000);
  EXPECT_LT(farthest(nothing, 0, Dof::Grip), 0.5);
  OperatorTask unreachable;
  unreachable.targets = {{5.0, 3.0, -8.0}, {0.0, 0.5, 0.0}};
  const Session trying = perform(unreachable, 10, 30'000);
  for (const MasterReading& r : trying.readings) {
    for (const double si : r.si) ASSERT_TRUE(std::isfinite(si));
  }
}

TEST(SimulatedMaster, GivesUpAWorkplaceItCannotReach) {
  // The world does not answer to the stick.
  OperatorTask task = someTask();
  SimulatedMaster master(task, Rig{}, 12);
  WorldState stuck;
  stuck.base = task.start;
  double closed = 0.0;
  for (int k = 1; k <= 60'000; ++k)
    closed = std::max(closed, master.read(k * kPeriod, stuck)->si[index(Dof::Grip)]);
  EXPECT_GT(closed, 0.6) << "it works from where it is";
}

}  // namespace
}  // namespace coherency
