#include <array>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/body/ArmKinematics.h"
#include "common/math/Rotation.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

const DofInfo& joint(std::size_t j) {
  return dofTable()[index(Dof::ShoulderFlexion) + j];
}

ArmJoints hanging(const Rig& rig) {
  return {0.0, -rig.shoulder_tilt_up, rig.shoulder_tilt_back, 0, 0, 0, 0};
}

ArmJoints randomJoints(double margin = 0.0) {
  ArmJoints joints{};
  for (std::size_t j = 0; j < kArmJointCount; ++j) {
    joints[j] = random::real(joint(j).min + margin, joint(j).max - margin);
  }
  return joints;
}

bool withinLimits(const ArmJoints& joints) {
  for (std::size_t j = 0; j < kArmJointCount; ++j) {
    if (!(joints[j] >= joint(j).min && joints[j] <= joint(j).max)) return false;
  }
  return true;
}

TEST(ArmKinematics, AgreesWithTheIndependentReference) {
  std::ifstream file(COHERENCY_ARM_REFERENCE);
  std::string line;
  ASSERT_TRUE(std::getline(file, line));
  const ArmKinematics arm{Rig{}};
  int rows = 0;
  while (std::getline(file, line)) {
    std::array<double, 25> v{};
    std::istringstream fields(line);
    for (double& value : v) {
      std::string field;
      ASSERT_TRUE(std::getline(fields, field, ','));
      value = std::stod(field);
    }
    const ArmPose pose = arm.pose({v[0], v[1], v[2], v[3], v[4], v[5], v[6]});
    const auto expectNear = [&](const Coord3& p, std::size_t i) {
      EXPECT_LT(norm(p - Coord3(v[i], v[i + 1], v[i + 2])), 1e-9) << "row " << rows << " column " << i;
    };
    expectNear(pose.t_shoulder_forearm.origin(), 7);
    expectNear(pose.t_shoulder_hand.origin(), 10);
    expectNear(pose.palm, 13);
    for (int k = 0; k < 9; ++k) {
      EXPECT_NEAR(pose.t_shoulder_hand(k / 3, k % 3), v[16 + static_cast<std::size_t>(k)], 1e-9)
          << "row " << rows;
    }
    ++rows;
  }
  EXPECT_GE(rows, 1 + 128 + 50) << "hanging, every corner of the limits, and others";
}

TEST(ArmKinematics, UpperArmHangsWhereTheDataSaysSo) {
  const Rig rig;
  const ArmPose pose = ArmKinematics(rig).pose({0.0, -0.4363323, 0.5235988, 0, 0, 0, 0});
  EXPECT_LT(norm(pose.t_shoulder_forearm.origin() - Coord3(0, -rig.upper_arm, 0)), 1e-6);
  EXPECT_LT(norm(pose.palm - Coord3(0, -(rig.upper_arm + rig.forearm + rig.hand), 0)), 1e-6);
}

TEST(ArmKinematics, PositiveJointsMoveAsTheTableSays) {
  const Rig rig;
  const ArmKinematics arm(rig);
  const ArmPose rest = arm.pose(hanging(rig));
  const auto moved = [&](std::size_t j) {
    ArmJoints joints = hanging(rig);
    joints[j] += 0.2;
    return arm.pose(joints);
  };
  EXPECT_LT(moved(0).palm.z, rest.palm.z - 0.05) << "flexion raises forward";
  EXPECT_GT(moved(1).palm.x, rest.palm.x + 0.05) << "abduction moves away from the body";
  EXPECT_LT(moved(3).palm.z, rest.palm.z - 0.05) << "elbow bends forward";
  // Bent elbow, turned inward: the hand goes across the body, to the left.
  ArmJoints bent = hanging(rig);
  bent[3] = 1.5;
  ArmJoints inward = bent;
  inward[2] += 0.2;
  EXPECT_LT(arm.pose(inward).palm.x, arm.pose(bent).palm.x - 0.05);
  // Palm's normal is -y of the hand, the thumb's side -z.
  const TransformMatrix& hand = rest.t_shoulder_hand;
  EXPECT_GT(dot(moved(5).palm - rest.palm, hand.vector({0, 1, 0})), 0.01) << "extension, away from the palm";
  EXPECT_GT(dot(moved(6).palm - rest.palm, hand.vector({0, 0, -1})), 0.01) << "radial, to the thumb";
}

RC_GTEST_PROP(ArmKinematics, FramesAreRigidAndSegmentsKeepTheirLength, ()) {
  const Rig rig;
  const ArmPose pose = ArmKinematics(rig).pose(randomJoints());
  RC_ASSERT(pose.t_shoulder_upper.isRigid() && pose.t_shoulder_forearm.isRigid() &&
            pose.t_shoulder_hand.isRigid());
  RC_ASSERT(pose.t_shoulder_upper.origin() == Coord3());
  const Coord3 elbow = pose.t_shoulder_forearm.origin();
  const Coord3 wrist = pose.t_shoulder_hand.origin();
  RC_ASSERT(norm(elbow - pose.t_shoulder_upper.point({rig.upper_arm, 0, 0})) < 1e-12);
  RC_ASSERT(norm(wrist - pose.t_shoulder_forearm.point({rig.forearm, 0, 0})) < 1e-12);
  RC_ASSERT(norm(pose.palm - pose.t_shoulder_hand.point({rig.hand, 0, 0})) < 1e-12);
}

const ArmJoints kSeed = {0.3, -0.4, 0.5, 1.2, 0.0, 0.0, 0.0};

TEST(ArmInverse, ReachesNearlyAllThatAnArmReached) {
  const ArmKinematics arm{Rig{}};
  std::mt19937_64 engine(7);
  int reached = 0;
  for (int i = 0; i < 2000; ++i) {
    ArmJoints truth{};
    for (std::size_t j = 0; j < kArmJointCount; ++j) {
      const double share = static_cast<double>(engine() >> 11) * 0x1.0p-53;
      truth[j] = joint(j).min + 0.1 + share * (joint(j).max - joint(j).min - 0.2);
    }
    reached += arm.solve(arm.pose(truth).palm, nullptr, kSeed).position_error_m < 1e-6 ? 1 : 0;
  }
  EXPECT_GE(reached, 1980);
}

RC_GTEST_PROP(ArmInverse, KeepsItsLimitsAndTellsItsError, ()) {
  const ArmKinematics arm{Rig{}};
  const Coord3 palm = random::vector(1.0);
  const auto solution = arm.solve(palm, nullptr, randomJoints());
  RC_ASSERT(withinLimits(solution.joints));
  RC_ASSERT(std::abs(norm(arm.pose(solution.joints).palm - palm) - solution.position_error_m) < 1e-12);
  RC_ASSERT(solution.angle_error_rad == 0.0);
}

RC_GTEST_PROP(ArmInverse, FollowsASmallMoveExactlyAndNearTheSeed, ()) {
  const ArmKinematics arm{Rig{}};
  ArmJoints truth = randomJoints(0.3);
  truth[3] = random::real(0.5, 2.3);  // away from the straight arm
  ArmJoints seed = truth;
  for (double& j : seed) j += random::real(-0.05, 0.05);
  const ArmPose goal = arm.pose(truth);
  const TransformMatrix hand = goal.t_shoulder_hand.linear();
  const auto place = arm.solve(goal.palm, nullptr, seed);
  RC_ASSERT(place.position_error_m < 1e-8);
  const auto both = arm.solve(goal.palm, &hand, seed);
  RC_ASSERT(both.position_error_m < 1e-8);
  RC_ASSERT(both.angle_error_rad < 0.05);
  for (std::size_t j = 0; j < kArmJointCount; ++j) RC_ASSERT(std::abs(place.joints[j] - seed[j]) < 0.4);
}

RC_GTEST_PROP(ArmInverse, ApproachesWhatIsOutOfReach, ()) {
  const Rig rig;
  const ArmKinematics arm(rig);
  const Coord3 ahead = normalized(Coord3{random::real(-0.3, 0.5), random::real(-0.5, 0.5), -1.0});
  const double reach = rig.upper_arm + rig.forearm + rig.hand;
  const auto solution = arm.solve(ahead * 3.0, nullptr, {0.5, -0.4, 0.5, 1.0, 0, 0, 0});
  RC_ASSERT(withinLimits(solution.joints));
  RC_ASSERT(std::abs(solution.position_error_m - (3.0 - reach)) < 0.05);
}

TEST(ArmInverse, ASeedOutsideTheLimitsIsBroughtInside) {
  const auto solution = ArmKinematics{Rig{}}.solve({0.2, -0.2, -0.3}, nullptr, {9, 9, 9, 9, 9, 9, 9});
  EXPECT_TRUE(withinLimits(solution.joints));
}

RC_GTEST_PROP(ArmInverse, IsDeterministic, ()) {
  const ArmKinematics arm{Rig{}};
  const Coord3 palm = random::vector(0.6);
  const TransformMatrix hand = random::rotationMatrix();
  const ArmJoints seed = randomJoints();
  RC_ASSERT(arm.solve(palm, &hand, seed).joints == arm.solve(palm, &hand, seed).joints);
}

}  // namespace
}  // namespace coherency
