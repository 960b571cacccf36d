// The virtual human as a tree of shapes: the rig's size, the posture's frames, and every DOF to be seen.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/body/SlaveRobot.h"
#include "common/body/VirtualHuman.h"
#include "tests/human/Support.h"
#include "tests/math/Random.h"

namespace coherency::human {
namespace {

class VirtualHumanOf : public testing::TestWithParam<const char*> {
 protected:
  std::array<double, kDofCount> neutral() const { return neutralPosture(rig_); }

  Rig rig_ = rigOf(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Rigs, VirtualHumanOf, testing::Values("default", "small", "large"));

TEST_P(VirtualHumanOf, ShowsEveryDof) {
  VirtualHuman human(rig_);
  expectShown(human, Dof::HeadX, Dof::PedalRight, "");
}

TEST_P(VirtualHumanOf, ShowsItsOwnMotionOnItsOwnBody) {
  VirtualHuman human(rig_);
  expectShown(human, Dof::HeadX, Dof::HeadRoll, "head shape");
  expectShown(human, Dof::HeadX, Dof::HeadZ, "trunk/thorax");
  expectShown(human, Dof::ShoulderFlexion, Dof::Grip, "virtual human/right arm");
  expectShown(human, Dof::StickX, Dof::StickTwist, "virtual human/left arm");
  expectShown(human, Dof::PedalLeft, Dof::PedalLeft, "virtual human/left leg");
  expectShown(human, Dof::PedalRight, Dof::PedalRight, "virtual human/right leg");
}

TEST_P(VirtualHumanOf, ForgetsWhatItDidBefore) {
  VirtualHuman human(rig_);
  expectToForget(human);
}

TEST_P(VirtualHumanOf, EyesAreTheRigsDistanceApartInTheHead) {
  VirtualHuman human(rig_);
  auto si = neutral();
  si[index(Dof::HeadYaw)] = 0.7;
  si[index(Dof::HeadPitch)] = -0.4;
  si[index(Dof::HeadRoll)] = 0.2;
  human.setSample(sampleOf(rig_, si));
  const TransformMatrix left = human.eye(Eye::Left).globalTransform();
  const TransformMatrix right = human.eye(Eye::Right).globalTransform();
  const Coord3 apart = right.origin() - left.origin();
  EXPECT_NEAR(norm(apart), rig_.eye_distance, 1e-12);
  const TransformMatrix head = human.posture().t_body_head;
  EXPECT_NEAR(norm(apart - head.vector({rig_.eye_distance, 0.0, 0.0})), 0.0, 1e-12) << "along the head's x";
  EXPECT_NEAR(norm((left.origin() + right.origin()) / 2.0 - human.eye(Eye::Mono).globalTransform().origin()),
              0.0, 1e-12);
  EXPECT_NEAR(norm(human.eye(Eye::Mono).globalTransform().origin() -
                   head.point({0.0, rig_.eye_up, -rig_.eye_forward})),
              0.0, 1e-12);
}

TEST_P(VirtualHumanOf, HandIsWhereTheKinematicsSay) {
  VirtualHuman human(rig_);
  const ArmKinematics arm(rig_);
  auto si = neutral();
  si[index(Dof::ShoulderFlexion)] = 1.1;
  si[index(Dof::ShoulderRotation)] = -0.3;
  si[index(Dof::ElbowFlexion)] = 0.8;
  si[index(Dof::ForearmRotation)] = 0.5;
  si[index(Dof::WristFlexion)] = 0.3;
  const MotionSample sample = sampleOf(rig_, si);
  human.setSample(sample);
  const Posture expected = posture(rig_, arm, sample);
  const TransformMatrix hand = expected.t_body_shoulder * expected.right_arm.t_shoulder_hand;
  const TransformMatrix seen = human.rightHand().globalTransform();
  EXPECT_LT(largestDifference(seen, hand), 1e-12);
}

/// Middle of everything drawn under a named object, in the body frame.
Coord3 middleOf(const VirtualHuman& human, const std::string& words) {
  Coord3 sum;
  std::size_t count = 0;
  for (const auto& [object, vertices] : drawn(human)) {
    if (object->path().find(words) == std::string::npos) continue;
    for (const Coord3& v : vertices) sum += v, ++count;
  }
  EXPECT_GT(count, 0U) << "nothing is called " << words;
  return count > 0 ? sum / static_cast<double>(count) : sum;
}

TEST_P(VirtualHumanOf, LeftHandStaysOnTheStick) {
  VirtualHuman human(rig_);
  human.setSample(sampleOf(rig_, neutral()));
  const Coord3 rest = middleOf(human, "left arm hand palm") - middleOf(human, "joystick handle");
  EXPECT_LT(norm(rest), 0.12);
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      auto si = neutral();
      si[index(Dof::StickX)] = x;
      si[index(Dof::StickY)] = y;
      human.setSample(sampleOf(rig_, si));
      EXPECT_LT(norm(middleOf(human, "left arm hand palm") - middleOf(human, "joystick handle") - rest), 0.04)
          << x << ' ' << y;
    }
}

TEST(VirtualHuman, DrawsNothingWhereNobodyIsToBeSeen) {
  const VirtualHuman nobody(Rig{}, HumanShown::None);
  EXPECT_EQ(nobody.polygonCount(), 0U);
}

TEST(VirtualHuman, RefusesAnAbsurdRig) {
  Rig rig;
  rig.upper_arm = -0.1;
  EXPECT_THROW(VirtualHuman{rig}, std::domain_error);
  rig = {};
  rig.eye_distance = 0.0;
  EXPECT_THROW(VirtualHuman{rig}, std::domain_error) << "two eyes never stand in one place";
}

TEST(Bodies, CanBeBuiltWithEachMeasureAtBothEndsOfItsRange) {
  for (const RigField& field : rigFields())
    for (const double end : {field.min, field.max}) {
      Rig rig;
      rig.*field.value = end;
      EXPECT_NO_THROW({
        const VirtualHuman human(rig);
        const SlaveRobot robot(robotRig(rig));
      }) << field.name
         << " = " << end;
    }
}

}  // namespace
}  // namespace coherency::human
