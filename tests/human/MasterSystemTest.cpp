// The master system: every DOF it measures shows where it is measured, and it stays with the operator.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "common/body/VirtualHuman.h"
#include "common/body/master/MasterSystem.h"
#include "common/scene/Senses.h"
#include "tests/human/Support.h"

namespace coherency::human {
namespace {

class MasterOf : public testing::TestWithParam<const char*> {
 protected:
  Rig rig_ = rigOf(GetParam());
  VirtualHuman human_{rig_};
};
INSTANTIATE_TEST_SUITE_P(Rigs, MasterOf, testing::Values("default", "small", "large"));

TEST_P(MasterOf, ShowsEveryDofWhereItIsMeasured) {
  expectShown(human_, Dof::HeadX, Dof::HeadRoll, "master system/head link/headset/");
  expectShown(human_, Dof::HeadX, Dof::HeadZ, "master system/head link/head link upper member");
  expectShown(human_, Dof::ShoulderFlexion, Dof::WristDeviation, "master system/exoskeleton");
  expectShown(human_, Dof::Grip, Dof::Grip,
              "master system/exoskeleton/exoskeleton hand/exoskeleton finger lever");
  expectShown(human_, Dof::StickX, Dof::StickTwist, "master system/joystick/joystick stick");
  expectShown(human_, Dof::PedalLeft, Dof::PedalLeft, "master system/left pedal/left pedal plate");
  expectShown(human_, Dof::PedalRight, Dof::PedalRight, "master system/right pedal/right pedal plate");
}

/// The exoskeleton's frame that each joint turns first.
TEST_P(MasterOf, ShowsEachJointOfTheArmOnALinkOfItsOwn) {
  const std::vector<std::pair<Dof, const char*>> links = {
      {Dof::ShoulderFlexion, "exoskeleton shoulder/"},
      {Dof::ShoulderAbduction, "exoskeleton shoulder ring/"},
      {Dof::ShoulderRotation, "exoskeleton upper arm/"},
      {Dof::ElbowFlexion, "exoskeleton elbow/"},
      {Dof::ForearmRotation, "exoskeleton forearm/"},
      {Dof::WristDeviation, "exoskeleton wrist/"},
      {Dof::WristFlexion, "exoskeleton hand/"}};
  for (const auto& [dof, link] : links) expectShown(human_, dof, dof, link);
}

double fromSegment(const Coord3& p, const Coord3& a, const Coord3& b) {
  const Coord3 span = b - a;
  return norm(p - a - span * std::clamp(dot(p - a, span) / dot(span, span), 0.0, 1.0));
}

/// From the arm's axis: shoulder, elbow, wrist, and as far beyond the palm as the wrist is before it.
double fromArm(const Posture& posture, const Coord3& point) {
  const ArmPose& arm = posture.right_arm;
  const Coord3 p = posture.t_body_shoulder.rigidInverse().point(point);
  const Coord3 elbow = arm.t_shoulder_forearm.origin();
  const Coord3 wrist = arm.t_shoulder_hand.origin();
  return std::min({fromSegment(p, {}, elbow), fromSegment(p, elbow, wrist),
                   fromSegment(p, wrist, wrist + (arm.palm - wrist) * 2.0)});
}

TEST_P(MasterOf, ExoskeletonKeepsBesideTheArmItMeasures) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    human_.setSample(randomSample(rig_, seed));
    double farthest = 0.0;
    for (const auto& [object, vertices] : drawn(human_)) {
      const std::string path = object->path();
      const bool link = path.find("/exoskeleton/") != std::string::npos &&
                        path.find("carrier") == std::string::npos &&
                        path.find("bracket") == std::string::npos;
      for (const Coord3& v : vertices)
        if (link) farthest = std::max(farthest, fromArm(human_.posture(), v));
    }
    EXPECT_GT(farthest, 0.05);
    EXPECT_LE(farthest, 0.15) << "posture " << seed;
  }
}

TEST_P(MasterOf, StaysWithinItsFootprint) {
  human_.setSample(sampleOf(rig_, neutralPosture(rig_)));
  expectWithin(masterFootprint(rig_), human_,
               {"right arm", "exoskeleton shoulder", "exoskeleton upper arm", "exoskeleton elbow",
                "exoskeleton forearm", "exoskeleton wrist", "exoskeleton hand"});
}

TEST_P(MasterOf, StandsOnTheFloor) {
  double lowest = 1.0;
  for (const auto& [object, vertices] : drawn(human_))
    for (const Coord3& v : vertices) lowest = std::min(lowest, v.y);
  EXPECT_GE(lowest, -1e-9);
  EXPECT_LT(lowest, 0.01);
}

TEST_P(MasterOf, GoesUpToATableWithItsFeetUnderIt) {
  constexpr double kTableAhead = 0.41;  // m, from the base at the workplace (configs/scenes/laboratory.toml)
  constexpr double kTableHigh = 0.70;
  for (const FootprintDisc& disc : masterFootprint(rig_))
    EXPECT_TRUE(disc.high < kTableHigh || disc.radius - disc.z <= kTableAhead)
        << disc.x << ' ' << disc.z << ' ' << disc.radius;
}

TEST(MasterSystem, HumsAndIsSoftToSitOn) {
  const VirtualHuman human{Rig{}};
  bool hums = false;
  std::string cushion;
  forEachObject(*human.master(), TransformMatrix{}, [&](const VRObject& object, const TransformMatrix&) {
    hums = hums || object.attribute<SoundSource>() != nullptr;
    if (object.name() == "seat cushion") cushion = object.attribute<Surface>()->material;
  });
  EXPECT_TRUE(hums);
  EXPECT_EQ(cushion, "foam");
}

}  // namespace
}  // namespace coherency::human
