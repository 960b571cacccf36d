#include <cmath>

#include <gtest/gtest.h>

#include "common/math/FixedPoint.h"
#include "motion_server/device/simulated/Workplan.h"

namespace coherency {
namespace {

constexpr double kEdge = 0.055;
constexpr double kOnTable = 0.7475;
const Coord3 kComfortable{0.1, 0.75, -0.65};

Movable at(double x, double z, int level = 0) {
  Movable m;
  m.x_nm = nanometresFromMetres(x);
  m.y_nm = nanometresFromMetres(kOnTable + level * kEdge);
  m.z_nm = nanometresFromMetres(z);
  return m;
}

struct Bench {
  explicit Bench(std::initializer_list<Movable> blocks) : plan(std::vector<double>(blocks.size(), kEdge)) {
    for (const Movable& m : blocks) world.movables.push_back(m);
    plan.remember(world);
  }
  std::optional<Transfer> next() {
    return plan.next(
        world, [](const Coord3& block) { return std::hypot(block.x, block.z) < 0.95; }, kComfortable, chance);
  }
  /// As if it had been done.
  void carryOut(const Transfer& t) {
    world.movables[t.block] = at(t.to.x, t.to.z, static_cast<int>(std::lround((t.to.y - kOnTable) / kEdge)));
  }

  WorldState world;
  Workplan plan;
  Chance chance{1};
};

TEST(Workplan, BuildsOnWhatIsNearestToHand) {
  Bench bench{at(-0.2, -0.8), at(0.1, -0.6), at(0.3, -0.9)};
  const auto first = bench.next();
  ASSERT_TRUE(first);
  EXPECT_NE(first->block, 1U);
  EXPECT_NEAR(first->to.x, 0.1, 1e-9);
  EXPECT_NEAR(first->to.y, kOnTable + kEdge, 1e-9);
  bench.carryOut(*first);
  const auto second = bench.next();
  ASSERT_TRUE(second);
  EXPECT_NEAR(second->to.y, kOnTable + 2 * kEdge, 1e-9);
  EXPECT_NE(second->block, first->block);
}

TEST(Workplan, TakesTheTowerDownFromTheTopAndBeginsAgain) {
  Bench bench{at(-0.2, -0.8), at(0.1, -0.6), at(0.3, -0.9)};
  for (int i = 0; i < 2; ++i) bench.carryOut(*bench.next());
  const WorldState built = bench.world;
  const auto top = bench.next();
  ASSERT_TRUE(top);
  EXPECT_NEAR(transform(built.movables[top->block]).origin().y, kOnTable + 2 * kEdge, 1e-9);
  bench.carryOut(*top);
  bench.carryOut(*bench.next());
  EXPECT_NEAR(metresFromNanometres(bench.world.movables[0].x_nm), -0.2, 1e-9) << "back where it was";
  EXPECT_NEAR(bench.next()->to.y, kOnTable + kEdge, 1e-9) << "and up again";
}

TEST(Workplan, NeedsThreeThatAreWithinReach) {
  EXPECT_FALSE((Bench{at(0.0, -0.6), at(0.1, -0.6)}.next()));
  EXPECT_FALSE((Bench{at(0.0, -0.6), at(0.1, -0.6), at(0.0, -1.5)}.next())) << "too far";
  EXPECT_FALSE((Bench{at(0.0, -0.6), at(0.1, -0.6), at(0.2, -0.6, -13)}.next())) << "on the floor";
  Bench held{at(0.0, -0.6), at(0.1, -0.6), at(0.2, -0.6)};
  held.world.movables[2].holder = Holder::RobotHand;
  EXPECT_FALSE(held.next()) << "somebody has it";
}

}  // namespace
}  // namespace coherency
