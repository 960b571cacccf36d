// The slave robot: every DOF it follows shows, its hand is where the kinematics say, and it has the size
// asked.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "common/body/SlaveRobot.h"
#include "common/scene/Light.h"
#include "common/scene/Senses.h"
#include "common/world/Hands.h"
#include "tests/human/Support.h"
#include "tests/math/Random.h"

namespace coherency::human {
namespace {

class RobotOf : public testing::TestWithParam<const char*> {
 protected:
  Rig rig_ = robotRig(rigOf(GetParam()));
  SlaveRobot robot_{rig_};
};
INSTANTIATE_TEST_SUITE_P(Rigs, RobotOf, testing::Values("default", "small", "large"));

TEST_P(RobotOf, ShowsEveryDofItFollows) {
  expectShown(robot_, Dof::HeadX, Dof::HeadRoll, "robot head");
  expectShown(robot_, Dof::ShoulderFlexion, Dof::WristDeviation, "robot arm");
  expectShown(robot_, Dof::Grip, Dof::Grip, "robot hand");
}

TEST_P(RobotOf, ShowsEachJointOnAPartOfItsOwn) {
  expectShown(robot_, Dof::HeadYaw, Dof::HeadYaw, "robot neck pan");
  expectShown(robot_, Dof::HeadPitch, Dof::HeadPitch, "robot neck tilt");
  expectShown(robot_, Dof::HeadRoll, Dof::HeadRoll, "robot head frame");
  const std::vector<std::pair<Dof, const char*>> parts = {
      {Dof::ShoulderFlexion, "robot shoulder/"},   {Dof::ShoulderAbduction, "robot shoulder block/"},
      {Dof::ShoulderRotation, "robot upper arm/"}, {Dof::ElbowFlexion, "robot elbow/"},
      {Dof::ForearmRotation, "robot forearm/"},    {Dof::WristDeviation, "robot wrist/"},
      {Dof::WristFlexion, "robot hand/"}};
  for (const auto& [dof, part] : parts) expectShown(robot_, dof, dof, part);
}

TEST_P(RobotOf, ForgetsWhatItDidBefore) {
  expectToForget(robot_);
}

TEST_P(RobotOf, StaysWithinItsFootprint) {
  robot_.setSample(sampleOf(rig_, neutralPosture(rig_)));
  expectWithin(robotFootprint(rig_), robot_, {"robot arm"});
}

TEST_P(RobotOf, HandIsWhereTheKinematicsSay) {
  for (const double scale : {0.5, 1.0, 2.0}) {
    Rig operator_rig = rigOf(GetParam());
    operator_rig.robot_scale = scale;
    const Rig rig = robotRig(operator_rig);
    SlaveRobot robot(rig);
    for (unsigned seed = 1; seed <= 50; ++seed) {
      const MotionSample sample = scaled(randomSample(operator_rig, seed), scale);
      robot.setSample(sample);
      const Posture expected = posture(rig, ArmKinematics(rig), sample);
      const TransformMatrix hand = expected.t_body_shoulder * expected.right_arm.t_shoulder_hand;
      EXPECT_LT(largestDifference(robot.rightHand().globalTransform(), hand), 1e-12);
    }
  }
}

TEST_P(RobotOf, OfAnotherScaleIsTheSameRobotOfThatScale) {
  for (const double scale : {0.5, 2.0}) {
    Rig operator_rig = rigOf(GetParam());
    operator_rig.robot_scale = scale;
    SlaveRobot other(robotRig(operator_rig));
    for (unsigned seed = 0; seed < 5; ++seed) {
      MotionSample sample = randomSample(operator_rig, seed);
      // Lengths of whole micrometres when halved, too.
      for (const Dof dof : {Dof::HeadX, Dof::HeadY, Dof::HeadZ}) sample.units[index(dof)] &= ~1;
      robot_.setSample(sample);
      other.setSample(scaled(sample, scale));
      const std::vector<Face> faces = facesOf(robot_);
      const std::vector<Face> other_faces = facesOf(other);
      ASSERT_EQ(faces.size(), other_faces.size());
      double farthest = 0.0;
      for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t k = 0; k < faces[i].corners.size(); ++k)
          farthest = std::max(farthest, norm(other_faces[i].corners[k] - faces[i].corners[k] * scale));
      EXPECT_LT(farthest, 1e-9) << scale;
    }
  }
}

TEST(SlaveRobot, MovesHumsAndIsHard) {
  const SlaveRobot robot{robotRig(Rig{})};
  EXPECT_NE(robot.attribute<Moving>(), nullptr);
  bool hums = false;
  std::string hull;
  forEachObject(robot, TransformMatrix{}, [&](const VRObject& object, const TransformMatrix&) {
    hums = hums || object.attribute<SoundSource>() != nullptr;
    if (object.name() == "robot chest") hull = object.attribute<Surface>()->material;
  });
  EXPECT_TRUE(hums);
  EXPECT_EQ(hull, "plastic");
}

}  // namespace
}  // namespace coherency::human
