// Attributes for other senses, and a consumer of each. What the attribute's type is, VRObject does not know.

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/FixedPoint.h"
#include "common/scene/Primitives.h"
#include "common/scene/Senses.h"
#include "common/world/Hearing.h"
#include "common/world/Touch.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

/// A sense nobody here has thought of: no line of the library knows it.
struct Smell {
  std::string of;
};

TEST(Attributes, OfAnyTypeAreFoundByWhoKnowsIt) {
  VRObject cup("cup");
  EXPECT_EQ(cup.attribute<Smell>(), nullptr);
  cup.attach(Smell{"coffee"});
  cup.attach(SoundSource{"it steams", 10.0});
  ASSERT_NE(cup.attribute<Smell>(), nullptr);
  EXPECT_EQ(cup.attribute<Smell>()->of, "coffee");
  cup.attach(Smell{"tea"});
  EXPECT_EQ(cup.attribute<Smell>()->of, "tea") << "one of each type";
  EXPECT_EQ(cup.attribute<SoundSource>()->what, "it steams");
  EXPECT_EQ(cup.attribute<Surface>(), nullptr);
}

struct Room {
  Room() {
    for (auto* object : {&fan, &clock, &far}) root.addMember(object);
    fan.setPosition(-2.0, 1.0, 0.0);
    fan.attach(SoundSource{"a fan hums", 40.0});
    clock.setPosition(0.0, 1.0, -1.0);
    clock.attach(SoundSource{"a clock ticks", 30.0});
    far.setPosition(0.0, 1.0, 1000.0);
    far.attach(SoundSource{"a cough", 60.0});
  }
  VRObject root{"room"}, fan{"fan"}, clock{"clock"}, far{"far"};
};

TEST(Hearing, TellsWhatCanBeHeardFromHere) {
  Room room;
  const auto heard = heardFrom(room.root, TransformMatrix::translation({0.0, 1.0, 0.0}));
  ASSERT_EQ(heard.size(), 2U) << "the cough is too far away";
  EXPECT_EQ(heard[0].what, "a fan hums");
  EXPECT_NEAR(heard[0].level_db, 40.0 - 20.0 * std::log10(2.0), 1e-12);
  EXPECT_NEAR(heard[0].bearing_rad, kTurn / 4.0, 1e-12) << "to the left";
  EXPECT_NEAR(heard[1].level_db, 30.0, 1e-12);
  EXPECT_EQ(describe(heard), "a fan hums 2.0 m to the left (34 dB), a clock ticks 1.0 m ahead (30 dB)");
  EXPECT_EQ(describe(heardFrom(room.root, TransformMatrix::translation({0.0, 1.0, 300.0}))), "nothing");
}

TEST(Hearing, TurnsWithTheHead) {
  Room room;
  const TransformMatrix looking_left =
      TransformMatrix::translation({0.0, 1.0, 0.0}) * TransformMatrix::rotationY(kTurn / 4);
  const auto heard = heardFrom(room.root, looking_left);
  EXPECT_NEAR(heard[0].bearing_rad, 0.0, 1e-12) << "the fan is ahead now";
  EXPECT_NEAR(heard[1].bearing_rad, -kTurn / 4.0, 1e-12) << "the clock to the right";
}

RC_GTEST_PROP(Hearing, SixDecibelsForTwiceTheDistance, ()) {
  VRObject root("root"), source("source");
  source.attach(SoundSource{"it", 80.0});
  root.addMember(&source);
  const Coord3 at = random::direction() * random::real(0.2, 10.0);
  const auto level = [&](double factor) {
    source.setPosition(at * factor);
    return heardFrom(root, {}, -100.0).at(0).level_db;
  };
  RC_ASSERT(std::abs(level(1.0) - level(2.0) - 20.0 * std::log10(2.0)) < 1e-9);
}

struct Workbench {
  Workbench() {
    top.setSize({1.0, 0.04, 1.0});
    top.setPosition(0.0, 0.7, 0.0);
    bench.addMember(&top);
    bench.attach(Surface{"wood", 2e4});
    root.addMember(&bench);
    root.addMember(&bare);
    bare.setPosition(5.0, 0.0, 0.0);
  }
  VRObject root{"root"}, bench{"bench"};
  Box top{{1, 1, 1}, "bench top"}, bare{{1, 1, 1}, "bare box"};
};

TEST(Touch, TellsDepthForceAndMaterial) {
  const Workbench w;
  const auto touched = touchedBy({{0.1, 0.72 + 0.017, 0.2}, 0.02}, w.root, {});
  ASSERT_EQ(touched.size(), 1U);
  EXPECT_EQ(touched[0].object, "root/bench/bench top");
  EXPECT_EQ(touched[0].material, "wood") << "what stands above it says so";
  EXPECT_NEAR(touched[0].depth_m, 0.003, 1e-12);
  EXPECT_NEAR(touched[0].force_n, 60.0, 1e-9);
  EXPECT_NEAR(norm(touched[0].normal - Coord3{0.0, 1.0, 0.0}), 0.0, 1e-12);
  EXPECT_EQ(describe(touched), "bench top (wood), 3 mm deep, pushes back with 60 N");
}

TEST(Touch, PushesOutWhoReachedInWithHisCentreToo) {
  const Workbench w;
  const auto above = touchedBy({{0.1, 0.72 + 1e-6, 0.2}, 0.02}, w.root, {});
  const auto below = touchedBy({{0.1, 0.72 - 1e-6, 0.2}, 0.02}, w.root, {});
  ASSERT_EQ(above.size(), 1U);
  ASSERT_EQ(below.size(), 1U);
  EXPECT_NEAR(below[0].force_n, above[0].force_n, 0.1);
  EXPECT_NEAR(norm(below[0].normal - Coord3{0.0, 1.0, 0.0}), 0.0, 1e-12);
}

TEST(Touch, FindsNothingInTheAirNorWhereItShallNotLook) {
  const Workbench w;
  EXPECT_TRUE(touchedBy({{0.0, 0.75, 0.0}, 0.02}, w.root, {}).empty());
  EXPECT_TRUE(touchedBy({{0.0, 0.73, 0.0}, 0.02}, w.root, {&w.bench}).empty());
  EXPECT_EQ(describe(std::vector<Touched>{}), "nothing");
}

TEST(Touch, WithoutASurfaceThereIsNoForce) {
  const Workbench w;
  const auto touched = touchedBy({{5.0, 0.51, 0.0}, 0.02}, w.root, {});
  ASSERT_EQ(touched.size(), 1U);
  EXPECT_EQ(touched[0].force_n, 0.0);
  EXPECT_EQ(describe(touched), "bare box, 10 mm deep");
}

RC_GTEST_PROP(Touch, AgreesWithTheDistanceToABox, ()) {
  // The distance from a point to a cuboid, in closed form.
  VRObject root("root");
  const Coord3 half{random::real(0.1, 1.0), random::real(0.1, 1.0), random::real(0.1, 1.0)};
  Box box(half * 2.0, "box");
  box.setTransform(random::rigid(2.0));
  root.addMember(&box);
  const Coord3 local = random::vector(1.6);
  const Coord3 out{std::max(std::abs(local.x) - half.x, 0.0), std::max(std::abs(local.y) - half.y, 0.0),
                   std::max(std::abs(local.z) - half.z, 0.0)};
  const double deepest =
      std::max({std::abs(local.x) - half.x, std::abs(local.y) - half.y, std::abs(local.z) - half.z});
  const double distance = deepest < 0.0 ? deepest : norm(out);  // negative inside
  const double radius = random::real(0.01, 0.5);
  RC_PRE(std::abs(distance) > 1e-6 && std::abs(std::abs(distance) - radius) > 1e-6);
  const auto touched = touchedBy({box.transform().point(local), radius}, root, {});
  RC_ASSERT(touched.size() == (std::abs(distance) < radius ? 1U : 0U));
  if (!touched.empty()) RC_ASSERT(std::abs(touched[0].depth_m - (radius - distance)) < 1e-9);
}

}  // namespace
}  // namespace coherency
