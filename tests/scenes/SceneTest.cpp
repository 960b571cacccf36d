// The worlds one can be in: what stands where, and that it can be reached.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "common/motion/SampleGate.h"
#include "common/scene/FaceSet.h"
#include "common/world/Scene.h"
#include "common/world/Targets.h"

namespace coherency {
namespace {

MotionSample neutralSample(const Rig& rig) {
  SampleGate gate(neutralPosture(rig));
  MasterReading reading;
  reading.si = neutralPosture(rig);
  return gate.admit(reading, 1, 1);
}

struct Extent {
  Coord3 low{1e9, 1e9, 1e9};
  Coord3 high{-1e9, -1e9, -1e9};
  Coord3 middle() const { return 0.5 * (low + high); }
};

/// Box about all that is drawn whose path contains `words`, in the world.
Extent extentOf(const Scene& scene, const std::string& words) {
  Extent extent;
  forEachObject(scene, TransformMatrix{}, [&](const VRObject& object, const TransformMatrix& t_world_object) {
    if (object.faces() == nullptr || object.path().find(words) == std::string::npos) return;
    for (const Coord3& v : object.faces()->vertices) {
      const Coord3 p = t_world_object.point(v);
      extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y), std::min(extent.low.z, p.z)};
      extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y),
                     std::max(extent.high.z, p.z)};
    }
  });
  EXPECT_LE(extent.low.x, extent.high.x) << "nothing is called " << words;
  return extent;
}

TEST(Scenes, AreMadeByName) {
  for (const std::string& name : sceneNames()) {
    const auto scene = makeScene(name, Rig{});
    EXPECT_EQ(scene->name(), name);
    EXPECT_GT(scene->polygonCount(), 0U);
  }
}

TEST(Scenes, UnknownNamesAreAnsweredWithThoseThereAre) {
  try {
    makeScene("atlantis", Rig{});
    FAIL();
  } catch (const std::invalid_argument& e) {
    const std::string message = e.what();
    EXPECT_NE(message.find("atlantis"), std::string::npos);
    for (const std::string& name : sceneNames()) EXPECT_NE(message.find(name), std::string::npos);
  }
}

TEST(Scenes, ApplyPutsTheHumanOnItsBase) {
  const auto scene = makeScene("laboratory", Rig{});
  WorldState state;
  state.base.x_nm = 1'234'567'890;
  state.base.heading_units = 1 << 30;  // a quarter turn to the left: ahead is -x
  scene->apply(state, neutralSample(Rig{}));
  const TransformMatrix t_world_body = scene->human().globalTransform();
  EXPECT_NEAR(t_world_body.origin().x, 1.23456789, 1e-12);
  EXPECT_NEAR(norm(t_world_body.vector({0.0, 0.0, -1.0}) - Coord3{-1.0, 0.0, 0.0}), 0.0, 1e-12);
}

TEST(Laboratory, NamesEverything) {
  const auto scene = makeScene("laboratory", Rig{});
  forEachObject(*scene, TransformMatrix{}, [](const VRObject& object, const TransformMatrix&) {
    EXPECT_FALSE(object.name().empty()) << object.path();
  });
}

TEST(Laboratory, BlocksStandOnTheTable) {
  const auto scene = makeScene("laboratory", Rig{});
  const Extent table = extentOf(*scene, "table top");
  for (const char* block : {"red block", "green block", "blue block"}) {
    const Extent extent = extentOf(*scene, block);
    EXPECT_NEAR(extent.low.y, table.high.y, 1e-4) << block;
    EXPECT_GT(extent.low.x, table.low.x) << block;
    EXPECT_LT(extent.high.x, table.high.x) << block;
    EXPECT_GT(extent.low.z, table.low.z) << block;
    EXPECT_LT(extent.high.z, table.high.z) << block;
  }
}

TEST(Laboratory, OneCannotDriveThroughWallsOrOntoTheTable) {
  const auto scene = makeScene("laboratory", Rig{});
  const DriveArea& area = scene->driveArea();
  EXPECT_GT(area.min_x, extentOf(*scene, "/left wall").high.x - 0.2);
  EXPECT_LT(area.max_x, extentOf(*scene, "/right wall").low.x + 0.2);
  EXPECT_GT(area.min_z, extentOf(*scene, "table top").high.z) << "the base stays before the table";
  for (const BasePose& pose : {scene->start(), scene->workplace()}) {
    const Coord3 p = transform(pose).origin();
    EXPECT_GE(p.x, area.min_x - 1e-9);
    EXPECT_LE(p.x, area.max_x + 1e-9);
    EXPECT_GE(p.z, area.min_z - 1e-9);
    EXPECT_LE(p.z, area.max_z + 1e-9);
  }
}

TEST(Laboratory, BlocksAreWithinReachOfTheWorkplace) {
  const Rig rig;
  const auto scene = makeScene("laboratory", rig);
  const ArmKinematics arm(rig);
  MotionSample sample = neutralSample(rig);
  // Leaning ahead by some 15 cm, as one does.
  sample.units[index(Dof::HeadZ)] -= 150'000;
  const Posture leaning = posture(rig, arm, sample);
  const TransformMatrix t_shoulder_world =
      (transform(scene->workplace()) * leaning.t_body_shoulder).rigidInverse();
  ASSERT_GE(scene->targets().size(), 3U);
  for (const Coord3& target : scene->targets())
    EXPECT_LT(arm.solve(t_shoulder_world.point(target), nullptr, armJoints(sample)).position_error_m, 0.01);
}

TEST(Laboratory, KeepsWithinItsBudget) {
  const auto scene = makeScene("laboratory", Rig{});
  std::size_t drawables = 0;
  forEachObject(*scene, TransformMatrix{}, [&](const VRObject& object, const TransformMatrix&) {
    drawables += object.faces() != nullptr;
  });
  EXPECT_LE(drawables, 400U);
  EXPECT_LE(scene->polygonCount(), 20'000U);
}

TEST(TargetsScene, StandsWhereItSays) {
  const Rig rig;
  const auto scene = makeScene("targets", rig);
  scene->apply(WorldState{}, neutralSample(rig));
  const Coord3 eyes = scene->human().eye(Eye::Mono).globalTransform().origin();
  const std::array<const char*, 3> names = {"red at 0.5 m", "yellow at 1 m", "cyan at 5 m"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Extent ball = extentOf(*scene, names[i]);
    EXPECT_NEAR(eyes.z - ball.middle().z, Targets::kDistances[i], 1e-6) << names[i];
    EXPECT_NEAR(ball.middle().x, eyes.x, 1e-6);
    EXPECT_NEAR(ball.high.y - ball.low.y, 2.0 * Targets::kAngularRadius * Targets::kDistances[i], 1e-9);
  }
  const Posture& p = scene->human().posture();
  const Coord3 wrist = (p.t_body_shoulder * p.right_arm.t_shoulder_hand).origin();
  EXPECT_NEAR(norm(extentOf(*scene, "magenta").middle() - wrist), 0.0, 1e-9);
  EXPECT_NEAR(
      norm(extentOf(*scene, "green at the palm").middle() - p.t_body_shoulder.point(p.right_arm.palm)), 0.0,
      1e-9);
}

}  // namespace
}  // namespace coherency
