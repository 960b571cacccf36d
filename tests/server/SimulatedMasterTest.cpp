#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "common/body/Posture.h"
#include "common/config/RigFile.h"
#include "common/config/SceneFile.h"
#include "common/math/FixedPoint.h"
#include "common/world/Scene.h"
#include "motion_server/authority/Authority.h"
#include "motion_server/device/SimulatedMaster.h"
#include "motion_server/device/simulated/OperatorTask.h"

namespace coherency {
namespace {

constexpr std::int64_t kPeriod = 1'000'000;

/// A plane with nothing on it but places to put a hand to.
struct Plain {
  OperatorTask task;
  WorldModel model;
};
Plain somewhere() {
  Plain p;
  p.task.targets = {{0.15, 0.83, -0.55}, {0.30, 0.83, -0.45}, {-0.10, 0.83, -0.70}};
  p.model.master.footprint = {{0.0, 0.0, 0.4, 0.0, 1.2}};
  p.model.master.start = basePose(0.6, 2.5, 0.4);
  return p;
}

/// The scene of that name with a simulated operator in it.
struct Staged {
  explicit Staged(const std::string& name, const Rig& rig_ = {})
      : rig(rig_), scene(readScene(name, COHERENCY_CONFIGS "/scenes"), rig), task(operatorTask(scene)) {}
  Rig rig;
  Scene scene;
  OperatorTask task;
};

Rig withRobot(double scale, Rig rig = {}) {
  rig.robot_scale = scale;
  return rig;
}

/// What the operator did, millisecond by millisecond, with the world answering.
struct Session {
  std::vector<MasterReading> readings;
  std::vector<WorldState> worlds;
  std::vector<Coord3> palms;  // of the virtual human, world
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

Session perform(const OperatorTask& task, const World& world, const WorldState& start, std::uint64_t seed,
                int milliseconds) {
  const Rig rig;
  Session session;
  SimulatedMaster simulated(task, rig, seed);
  Recorder recorder(simulated, session);
  AuthorityConfig config;
  config.start = start;
  Authority authority(config, world, recorder);
  const ArmKinematics arm(rig);
  for (int k = 1; k <= milliseconds; ++k) {
    const auto result = authority.sample(k * kPeriod, 0, 1);
    session.worlds.push_back(result->world);
    const Posture p = posture(rig, arm, result->sample);
    session.palms.push_back(
        transform(result->world.master.base).point(p.t_body_shoulder.point(p.right_arm.palm)));
  }
  for (const std::uint64_t refused : authority.refused()) EXPECT_EQ(refused, 0u);
  return session;
}

Session perform(const Plain& plain, std::uint64_t seed, int milliseconds) {
  const World world(plain.model);
  return perform(plain.task, world, world.initialState(), seed, milliseconds);
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

void expectContinuous(const Session& s, std::uint64_t seed, bool all_move) {
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
    if (all_move) {
      EXPECT_GT(fastest, 0.01) << dofTable()[i].name << " never moved, seed " << seed;
    }
  }
}

TEST(SimulatedMaster, EveryDofMovesContinuously) {
  const Staged laboratory("laboratory");
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    expectContinuous(perform(somewhere(), seed, 60'000), seed, true);
    expectContinuous(
        perform(laboratory.task, laboratory.scene.world(), laboratory.scene.initialState(seed), seed, 60'000),
        seed, false);  // no way there is long enough for the right pedal
  }
}

/// Milliseconds until a tower stood; -1: none within a minute and a half.
int towerAfter(const Staged& staged, Mode mode, std::uint64_t seed) {
  SimulatedMaster master(staged.task, staged.rig, seed);
  AuthorityConfig config;
  config.start = staged.scene.initialState(seed);
  config.start.mode = mode;
  Authority authority(config, staged.scene.world(), master);
  for (int k = 1; k <= 90'000; ++k) {
    authority.sample(k * kPeriod, 0, 1);
    if (authority.state().task.standing) return k;
  }
  return -1;
}

// Built with sanitizers, a second of work takes ten times as long: then fewer seeds.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uint64_t kSeeds = 5;
constexpr std::uint64_t kFewSeeds = 1;
#else
constexpr std::uint64_t kSeeds = 100;
constexpr std::uint64_t kFewSeeds = 6;
#endif

TEST(SimulatedMaster, BuildsTheTowerInBothModesWithEachOfManySeeds) {
  const Staged laboratory("laboratory");
  for (const Mode mode : {Mode::Operator, Mode::Robot}) {
    std::vector<int> times;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      times.push_back(towerAfter(laboratory, mode, seed));
      EXPECT_GT(times.back(), 0) << (mode == Mode::Robot ? "robot" : "operator") << " seed " << seed;
    }
    std::sort(times.begin(), times.end());
    std::cout << (mode == Mode::Robot ? "robot" : "operator") << ": towers after " << times.front() / 1e3
              << " to " << times.back() / 1e3 << " s, " << times[times.size() / 2] / 1e3
              << " s at the median\n";
  }
}

TEST(SimulatedMaster, BuildsWithEveryRigThatIsShipped) {
  for (const auto& file : std::filesystem::directory_iterator(COHERENCY_CONFIGS "/rigs")) {
    const Staged laboratory("laboratory", readRig(file.path().string()));
    for (const Mode mode : {Mode::Operator, Mode::Robot})
      for (std::uint64_t seed = 1; seed <= kFewSeeds; ++seed)
        EXPECT_GT(towerAfter(laboratory, mode, seed), 0)
            << file.path() << (mode == Mode::Robot ? " robot" : " operator") << " seed " << seed;
  }
}

TEST(SimulatedMaster, BuildsWithRobotsOfOtherSizes) {
  for (const double scale : {0.8, 0.9, 1.25, 1.4, 2.0}) {
    const Staged laboratory("laboratory", withRobot(scale));
    EXPECT_TRUE(outOfReach(laboratory.scene, laboratory.scene.initialState()).empty()) << scale;
    for (std::uint64_t seed = 1; seed <= kFewSeeds; ++seed)
      EXPECT_GT(towerAfter(laboratory, Mode::Robot, seed), 0) << "scale " << scale << " seed " << seed;
  }
}

TEST(SimulatedMaster, SaysWhoCannotReachTheBlocks) {
  for (const double scale : {0.5, 0.6}) {
    const Scene scene(readScene("laboratory", COHERENCY_CONFIGS "/scenes"), withRobot(scale));
    const std::vector<std::string> said = outOfReach(scene, scene.initialState());
    ASSERT_EQ(said.size(), 1U) << scale;
    EXPECT_NE(said[0].find("the robot (scale 0."), std::string::npos) << said[0];
    EXPECT_NE(said[0].find("cannot reach the blocks"), std::string::npos) << said[0];
  }
}

TEST(SimulatedMaster, DoesNotComplainOfABlockItHasNoUseFor) {
  SceneDescription description = readScene("blocks", COHERENCY_CONFIGS "/scenes");
  ObjectPlacement block;
  block.kind = "block";
  block.name = "block in the corner";
  block.place = basePose(2.5, 1.0, 0.0);
  block.place.y_nm = 30'000'000;
  description.objects.push_back(block);
  description.scatter.reset();
  const Scene scene(description, Rig{});
  EXPECT_TRUE(outOfReach(scene, scene.initialState()).empty());
}

TEST(SimulatedMaster, SitsDownWhereThereIsRoom) {
  const Staged blocks("blocks");
  const ReachPlanner planner{Rig{}};
  const Seating seating(planner, blocks.task.grasp_point);
  const BasePose& workplace = blocks.task.workplace;
  const std::vector<Coord3> far_aside = {transform(workplace).point({-0.55, 0.76, -0.55})};
  const auto aside = [&](bool clear) {
    const BasePose seat = seating.place(workplace, far_aside, 1.0,
                                        [&](const BasePose& base) { return clear || base == workplace; });
    return transform(workplace).rigidInverse().point(transform(seat).origin()).x;
  };
  EXPECT_LT(aside(true), -0.1);
  EXPECT_EQ(aside(false), 0.0) << "there is no room beside the workplace";
  BasePose border = workplace;
  border.x_nm = kWorldLimitNm;
  EXPECT_NO_THROW(seating.place(border, {transform(border).point({0.5, 0.76, -0.5})}, 1.0,
                                [](const BasePose&) { return true; }));
}

TEST(SimulatedMaster, BuildsAgainAndAgain) {
  const Staged blocks("blocks");
  SimulatedMaster master(blocks.task, Rig{}, 5);
  AuthorityConfig config;
  config.start = blocks.scene.initialState();
  Authority authority(config, blocks.scene.world(), master);
  for (int k = 1; k <= 240'000; ++k) authority.sample(k * kPeriod, 0, 1);
  EXPECT_GE(authority.state().task.towers, 3U);
}

TEST(SimulatedMaster, GoesOnInTheOtherModeWhenSwitched) {
  const Staged laboratory("laboratory");
  SimulatedMaster master(laboratory.task, Rig{}, 3);
  AuthorityConfig config;
  config.start = laboratory.scene.initialState();
  Authority authority(config, laboratory.scene.world(), master);
  bool robot_held = false;
  for (int k = 1; k <= 60'000; ++k) {
    if (k == 9'000) authority.switchTo(Mode::Robot);
    authority.sample(k * kPeriod, 0, 1);
    for (const Movable& m : authority.state().movables)
      robot_held = robot_held || m.holder == Holder::RobotHand;
  }
  EXPECT_TRUE(robot_held);
  EXPECT_GE(authority.state().task.towers, 1U);
}

TEST(SimulatedMaster, DrivesToTheWorkplaceAndPutsItsHandToEveryTarget) {
  const Plain plain = somewhere();
  const Session s = perform(plain, 1, 120'000);
  double nearest_base = 9.0;
  for (const WorldState& w : s.worlds) {
    nearest_base = std::min(nearest_base, std::hypot(metresFromNanometres(w.master.base.x_nm),
                                                     metresFromNanometres(w.master.base.z_nm)));
  }
  EXPECT_LT(nearest_base, 0.03);
  for (const Coord3& target : plain.task.targets) {
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
  Plain plain = somewhere();
  plain.model.master.start = plain.task.workplace;
  const Session s = perform(plain, 4, 30'000);
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
    Plain plain = somewhere();
    plain.model.master.start = plain.task.workplace;
    plain.task.targets = {{0.1, 0.78, z}};
    const Session s = perform(plain, 5, 20'000);
    double lowest = 9.0;
    for (const MasterReading& r : s.readings) lowest = std::min(lowest, r.si[index(Dof::HeadZ)]);
    return -lowest;
  };
  EXPECT_GT(leanFor(-0.85), leanFor(-0.45) + 0.15);
}

TEST(SimulatedMaster, TheHeadSitsOnTheNeckOfAnUpperBodyOfFixedLength) {
  const Rig rig;
  const ArmKinematics arm(rig);
  const Session s = perform(somewhere(), 6, 40'000);
  SampleGate gate(neutralPosture(rig));
  for (std::size_t k = 0; k < s.readings.size(); k += 50) {
    EXPECT_NEAR(posture(rig, arm, gate.admit(s.readings[k], 1, 0)).trunk_stretch, 1.0, 1e-4);
  }
}

TEST(SimulatedMaster, SameSeedSameMotionOtherSeedOther) {
  const Session a = perform(somewhere(), 8, 15'000);
  const Session b = perform(somewhere(), 8, 15'000);
  const Session c = perform(somewhere(), 9, 15'000);
  bool differs = false;
  for (std::size_t k = 0; k < a.readings.size(); ++k) {
    ASSERT_EQ(a.readings[k].si, b.readings[k].si) << k;
    differs = differs || a.readings[k].si != c.readings[k].si;
  }
  EXPECT_TRUE(differs);
  EXPECT_EQ(a.worlds.back(), b.worlds.back());
}

TEST(SimulatedMaster, GoesOnWhenThereIsNothingToDoOrToReach) {
  Plain idle = somewhere();
  idle.task.targets.clear();
  const Session nothing = perform(idle, 10, 20'000);
  for (const MasterReading& r : nothing.readings) EXPECT_LT(r.si[index(Dof::Grip)], 0.5);
  Plain unreachable = somewhere();
  unreachable.task.targets = {{5.0, 3.0, -8.0}, {0.0, 0.5, 0.0}};
  const Session trying = perform(unreachable, 10, 30'000);
  for (const MasterReading& r : trying.readings) {
    for (const double si : r.si) ASSERT_TRUE(std::isfinite(si));
  }
}

TEST(SimulatedMaster, GivesUpAWorkplaceItCannotReach) {
  // The world does not answer to the stick.
  const Plain plain = somewhere();
  SimulatedMaster master(plain.task, Rig{}, 12);
  WorldState stuck;
  stuck.master.base = plain.model.master.start;
  double closed = 0.0;
  for (int k = 1; k <= 60'000; ++k)
    closed = std::max(closed, master.read(k * kPeriod, stuck)->si[index(Dof::Grip)]);
  EXPECT_GT(closed, 0.6) << "it works from where it is";
}

}  // namespace
}  // namespace coherency
