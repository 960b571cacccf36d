#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/motion/SampleGate.h"
#include "tests/math/Random.h"
#include "tests/world/Support.h"

namespace coherency {
namespace {

using namespace worlds;

MotionSample withGrip(MotionSample sample, double grip) {
  sample.units[index(Dof::Grip)] = unitsFromRatio(grip);
  return sample;
}

/// A posture in which the hand is somewhere ahead.
MotionSample anyReach() {
  MotionSample sample = neutralSample(Rig{});
  sample.valid = kAllDofs;
  for (std::size_t j = 0; j < kArmJointCount; ++j) {
    const DofInfo& dof = dofTable()[index(Dof::ShoulderFlexion) + j];
    sample.units[index(Dof::ShoulderFlexion) + j] = unitsFromRadians(random::real(dof.min, dof.max));
  }
  return sample;
}

/// A world in which the only block is where the given hand would grasp it best, in the air.
struct Within {
  explicit Within(Holder which, const MotionSample& sample, const Coord3& off = {}, double scale = 1.0)
      : world(model(scale)) {
    state = world.initialState();
    Vehicle& vehicle = which == Holder::RobotHand ? state.robot : state.master;
    vehicle.base = basePose(3.0, -2.0, 0.7);
    const GraspingHand& hand = world.hand(which);
    const TransformMatrix t_world_hand = transform(vehicle.base) * hand.baseFromHand(sample);
    state.movables[0] = letGo(t_world_hand.point(hand.graspPoint() + off), quaternion(t_world_hand));
  }
  static WorldModel model(double scale) {
    WorldModel m = tableWorld(1);
    Rig rig;
    rig.robot_scale = scale;
    m.robot->rig = robotRig(rig);
    m.robot->scale = scale;
    return m;
  }
  World world;
  WorldState state;
};

/// Where the block is in the world.
TransformMatrix inWorld(const World& world, const WorldState& state, const MotionSample& sample) {
  const Movable& m = state.movables[0];
  if (m.holder == Holder::Nobody) return transform(m);
  const Vehicle& v = m.holder == Holder::RobotHand ? state.robot : state.master;
  return transform(v.base) * world.hand(m.holder).baseFromHand(sample) * transform(m);
}

RC_GTEST_PROP(Hands, TakeAndLetGoWithoutAJump, ()) {
  const auto which = *rc::gen::element(Holder::OperatorHand, Holder::RobotHand);
  const MotionSample sample = anyReach();
  Within w(which, sample, {}, *rc::gen::element(0.5, 1.0, 1.7));
  const TransformMatrix before = inWorld(w.world, w.state, sample);
  const GraspingHand& hand = w.world.hand(which);
  const BasePose base = which == Holder::RobotHand ? w.state.robot.base : w.state.master.base;
  RC_ASSERT(!hand.step(w.state, withGrip(sample, 0.2), base));
  RC_ASSERT(w.state.movables[0].holder == Holder::Nobody);
  RC_ASSERT(hand.step(w.state, withGrip(sample, 0.6), base));
  RC_ASSERT(w.state.movables[0].holder == which);
  RC_ASSERT(largestDifference(inWorld(w.world, w.state, sample), before) <
            5e-9);                                              // a few nanometres of rounding
  RC_ASSERT(!hand.step(w.state, withGrip(sample, 0.4), base));  // between open and closed it holds on
  RC_ASSERT(hand.step(w.state, withGrip(sample, 0.3), base));
  RC_ASSERT(w.state.movables[0].holder == Holder::Nobody);
  RC_ASSERT(largestDifference(inWorld(w.world, w.state, sample), before) < 1e-8);
}

RC_GTEST_PROP(Hands, CarryWhatTheyHold, ()) {
  const MotionSample from = anyReach();
  Within w(Holder::OperatorHand, from);
  const GraspingHand& hand = w.world.hand(Holder::OperatorHand);
  hand.step(w.state, withGrip(from, 0.7), w.state.master.base);
  const Movable held = w.state.movables[0];
  const MotionSample to = anyReach();
  w.state.master.base = basePose(-1.0, 5.0, -2.0);
  RC_ASSERT(!hand.step(w.state, withGrip(to, 0.7), w.state.master.base));
  RC_ASSERT(w.state.movables[0] ==
            held);  // its pose in the hand is what it was, and that is all the state knows
}

TEST(Hands, DoNotReachWhatIsTooFar) {
  const MotionSample sample = neutralSample(Rig{});
  for (const auto& [off, grasped] : {std::pair{0.045, true}, std::pair{0.06, false}}) {
    Within w(Holder::OperatorHand, sample, {off, 0.0, 0.0});
    EXPECT_EQ(w.world.hand(Holder::OperatorHand).step(w.state, withGrip(sample, 0.6), w.state.master.base),
              grasped);
    EXPECT_EQ(w.state.closed_hands, 1) << "the hand is closed either way";
  }
}

TEST(Hands, OneThatIsClosedAlreadyTakesNothing) {
  const MotionSample sample = neutralSample(Rig{});
  Within w(Holder::OperatorHand, sample);
  w.state.closed_hands = 1;
  EXPECT_FALSE(w.world.hand(Holder::OperatorHand).step(w.state, withGrip(sample, 0.9), w.state.master.base));
  EXPECT_EQ(w.state.movables[0].holder, Holder::Nobody);
}

TEST(Hands, DoNotTakeWhatAnotherHolds) {
  const MotionSample sample = neutralSample(Rig{});
  Within w(Holder::OperatorHand, sample);
  w.state.movables[0].holder = Holder::RobotHand;
  EXPECT_FALSE(w.world.hand(Holder::OperatorHand).step(w.state, withGrip(sample, 0.9), w.state.master.base));
  EXPECT_EQ(w.state.movables[0].holder, Holder::RobotHand);
}

TEST(Hands, HoldOnWhereTheGripIsNotMeasured) {
  // Through the gate, as the server does: it is the gate that keeps what was measured last.
  SampleGate gate(neutralPosture(Rig{}));
  MasterReading reading{neutralPosture(Rig{}), kAllDofs, 0};
  reading.si[index(Dof::Grip)] = 0.9;
  const MotionSample closed = gate.admit(reading, 1, 0);
  Within w(Holder::OperatorHand, closed);
  const GraspingHand& hand = w.world.hand(Holder::OperatorHand);
  ASSERT_TRUE(hand.step(w.state, closed, w.state.master.base));
  reading.si[index(Dof::Grip)] = 0.0;
  reading.valid = kAllDofs & ~mask(Dof::Grip);
  const MotionSample lost = gate.admit(reading, 2, 1'000'000'000);
  ASSERT_FALSE(lost.isValid(Dof::Grip));
  EXPECT_FALSE(hand.step(w.state, lost, w.state.master.base));
  EXPECT_EQ(w.state.movables[0].holder, Holder::OperatorHand);
  reading.valid = kAllDofs;
  EXPECT_TRUE(hand.step(w.state, gate.admit(reading, 3, 2'000'000'000), w.state.master.base)) << "it opens";
}

TEST(Hands, WorkAlikeAtTheEndOfTheWorld) {
  const MotionSample sample = neutralSample(Rig{});
  Within w(Holder::OperatorHand, sample);
  const GraspingHand& hand = w.world.hand(Holder::OperatorHand);
  Movable& m = w.state.movables[0];
  const Movable before = m;
  const BasePose near = w.state.master.base;
  BasePose far = near;
  const std::int64_t away = 900'000'000'000'000'000;
  far.x_nm += away;
  m.x_nm += away;
  hand.step(w.state, withGrip(sample, 0.9), far);
  const Movable held_far = m;
  hand.step(w.state, withGrip(sample, 0.1), far);
  EXPECT_LE(std::abs(m.x_nm - away - before.x_nm), 2);
  EXPECT_LE(std::abs(m.y_nm - before.y_nm), 2);
  m = before;
  hand.step(w.state, withGrip(sample, 0.9), near);
  EXPECT_EQ(m, held_far) << "to the last bit";
}

TEST(Hands, ScaledMultipliesLengthsAlone) {
  MotionSample sample = neutralSample(Rig{});
  sample.units[index(Dof::HeadX)] = 100'001;
  const MotionSample half = scaled(sample, 0.5);
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const bool length = info(dofAt(i)).kind == DofKind::Length;
    EXPECT_EQ(half.units[i], length ? std::llround(sample.units[i] * 0.5) : sample.units[i])
        << dofTable()[i].name;
  }
  EXPECT_EQ(scaled(sample, 1.0), sample);
}

}  // namespace
}  // namespace coherency
