// What the building task needs of the worlds it is done in: blocks that can be reached, and things that carry
// them.

#include <gtest/gtest.h>

#include "tests/scenes/Support.h"
#include "tests/world/Support.h"

namespace coherency {
namespace {

using namespace scenes;
using worlds::kEdge;

/// How far the palm of somebody at `place` stays from a point if they lean ahead as it suits them, by up to
/// 40 degrees about the hips; m.
double outOfReach(const Rig& rig, const BasePose& place, const Coord3& point) {
  const ArmKinematics arm(rig);
  const double height = rig.trunk_length + rig.neck_length;
  double least = 1e9;
  for (const double lean : {0.15, 0.3, 0.45, 0.6, 0.7}) {
    MotionSample sample = neutralSample(rig);
    sample.units[index(Dof::HeadY)] += unitsFromSi(DofKind::Length, height * (std::cos(lean) - 1.0));
    sample.units[index(Dof::HeadZ)] -= unitsFromSi(DofKind::Length, height * std::sin(lean));
    const Posture leaning = posture(rig, arm, sample);
    const TransformMatrix t_shoulder_world = (transform(place) * leaning.t_body_shoulder).rigidInverse();
    least = std::min(least,
                     arm.solve(t_shoulder_world.point(point), nullptr, armJoints(sample)).position_error_m);
  }
  return least;
}

TEST(Blocks, LieWithinReachOfBothWorkplaces) {
  const Rig rig;
  for (const char* name : {"laboratory", "blocks"}) {
    const Scene scene(described(name), rig);
    const SceneDescription& description = scene.description();
    EXPECT_EQ(scene.world().model().movables.size(), 3U);
    for (const std::uint64_t seed : {0U, 1U, 2U, 3U, 4U}) {
      for (const Movable& block : scene.initialState(seed).movables) {
        EXPECT_LT(outOfReach(rig, description.workplace, worlds::place(block)), 0.01) << name;
        if (!description.robot) continue;
        EXPECT_LT(outOfReach(robotRig(rig), description.robot->workplace, worlds::place(block)), 0.01)
            << name;
      }
    }
  }
}

TEST(Blocks, StandOnTheTableAndStay) {
  Scene scene(described("laboratory"), Rig{});
  const Extent table = extentOf(scene, "table/table top");
  for (const char* name : {"red block", "green block", "blue block"}) {
    const Extent block = extentOf(scene, name);
    EXPECT_NEAR(block.low.y, table.high.y, 1e-4) << name;
    EXPECT_GT(block.low.x, table.low.x) << name;
    EXPECT_LT(block.high.x, table.high.x) << name;
    EXPECT_GT(block.low.z, table.low.z) << name;
    EXPECT_LT(block.high.z, table.high.z) << name;
  }
  WorldState state = scene.initialState();
  const auto before = state.movables;
  worlds::run(scene.world(), state, worlds::driving({}), 500);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(transform(state.movables[i]), transform(before[i]));
    EXPECT_TRUE(state.movables[i].resting);
  }
}

/// Where a block comes to rest that is let go there.
Movable fallen(const Scene& scene, const Coord3& from) {
  WorldState state = scene.initialState();
  state.movables[0] = worlds::letGo(from);
  worlds::run(scene.world(), state, worlds::driving({}), 3000);
  EXPECT_TRUE(state.movables[0].resting);
  return state.movables[0];
}

TEST(Blocks, RestOnWhatCarriesThemWhereTheyAreLetGo) {
  const Scene scene(described("laboratory"), Rig{});
  struct Place {
    const char* on;
    double x, z, height;
  };
  constexpr Place kPlaces[] = {
      {"the table", -0.5, -1.0, 0.72},           {"the laboratory's desk", -2.93, -1.30, 0.74},
      {"the workbench", -0.3, 2.55, 0.86},       {"the cabinet", 3.30, -1.35, 0.85},
      {"the meeting table", 0.2, 6.4, 0.74},     {"an office's desk", 10.15, 1.25, 0.74},
      {"the corridor's bench", 3.9, -5.8, 0.44}, {"the floor", 1.5, 1.5, 0.0},
      {"the corridor's floor", 4.8, 3.0, 0.0}};
  for (const Place& p : kPlaces) {
    const Coord3 rest = worlds::place(fallen(scene, {p.x, p.height + 0.15, p.z}));
    EXPECT_NEAR(rest.x, p.x, 1e-3) << p.on;
    EXPECT_NEAR(rest.y, p.height + kEdge / 2, 1e-6) << p.on;
    EXPECT_NEAR(rest.z, p.z, 1e-3) << p.on;
  }
}

TEST(Blocks, DoNotStayInTheAirBesideATable) {
  const Scene scene(described("laboratory"), Rig{});
  EXPECT_NEAR(worlds::place(fallen(scene, {-0.2, 0.8, -0.80})).y, kEdge / 2, 1e-6);
}

}  // namespace
}  // namespace coherency
