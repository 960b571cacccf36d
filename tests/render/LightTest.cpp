// The light of what moves: lamps that come and go smoothly, and shadows that show how high a thing is.

#include <cmath>

#include <epoxy/gl.h>
#include <glm/geometric.hpp>

#include "common/math/FixedPoint.h"
#include "render_client/draw/LampSets.h"
#include "tests/render/Support.h"

namespace coherency {
namespace {

/// Two rooms with a wall between them at x = 0, a doorway in it, and lamps on both sides.
struct TwoRooms {
  TwoRooms() {
    const Material white = matt(0.8, 0.8, 0.8);
    scene.add<Box>({0.0, -0.05, 0.0}, white, Coord3{8.0, 0.1, 4.0});
    scene.add<Box>({0.0, 2.65, 0.0}, white, Coord3{8.0, 0.1, 4.0});
    scene.add<Box>({0.0, 1.3, -1.25}, white, Coord3{0.1, 2.6, 1.5});
    scene.add<Box>({0.0, 1.3, 1.25}, white, Coord3{0.1, 2.6, 1.5});
    scene.add<Box>({0.0, 2.3, 0.0}, white, Coord3{0.1, 0.6, 1.0});
    for (const double x : {-3.0, -1.5, 1.5, 3.0})
      for (const double z : {-1.2, 1.2}) scene.addLight({{x, 2.4, z}, {1.0, 0.9, 0.8}, 2.0, 8.0});
  }
  TestScene scene;
};

/// By lamp: what its colour was multiplied by.
std::vector<double> shares(const ChosenLamps& chosen, const Illumination& illumination) {
  std::vector<double> all;
  for (const Light& lamp : illumination.lamps) {
    all.push_back(0.0);
    for (const ChosenLamp& c : chosen.lamps)
      if (c.position == lamp.position) all.back() = c.colour.r / (lamp.colour.x * lamp.intensity);
  }
  return all;
}

TEST(LampChoice, NoLampAppearsOrVanishesSuddenlyOnTheWayThroughADoorway) {
  const TwoRooms rooms;
  const CompiledScene compiled(rooms.scene, rooms.scene.illumination());
  LampChoice choice(rooms.scene.illumination(), compiled);
  std::vector<double> last;
  double most = 0.0;
  double brightest_others = 0.0;
  for (int centimetre = -350; centimetre <= 350; ++centimetre) {
    const double x = 0.01 * centimetre;
    const ChosenLamps chosen = choice.at({x, 1.1, 0.3 * std::sin(x)});
    const std::vector<double> now = shares(chosen, rooms.scene.illumination());
    for (std::size_t i = 0; i < last.size(); ++i) most = std::max(most, std::abs(now[i] - last[i]));
    last = now;
    brightest_others = std::max<double>(brightest_others, brightness(chosen.others));
  }
  EXPECT_LT(most, 0.14) << "share of a lamp that came or went within a centimetre";
  EXPECT_GT(brightest_others, 0.0);
}

TEST(LampChoice, LampsBehindTheWallAreLeftOutAndTheNearestShineFully) {
  const TwoRooms rooms;
  const CompiledScene compiled(rooms.scene, rooms.scene.illumination());
  LampChoice choice(rooms.scene.illumination(), compiled);
  const std::vector<double> left = shares(choice.at({-1.0, 1.1, 1.8}), rooms.scene.illumination());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_GT(left[i], 0.65) << i;
  for (std::size_t i = 4; i < 8; ++i) EXPECT_EQ(left[i], 0.0) << i;
}

void expectSame(const ChosenLamps& a, const ChosenLamps& b) {
  for (std::size_t i = 0; i < kChosenLamps; ++i) {
    EXPECT_TRUE(a.lamps[i].position == b.lamps[i].position);
    EXPECT_EQ(a.lamps[i].colour, b.lamps[i].colour);
  }
  EXPECT_EQ(a.others, b.others);
}

TEST(LampChoice, DependsOnThePlaceAndNotOnTheWayThere) {
  const TwoRooms rooms;
  const CompiledScene compiled(rooms.scene, rooms.scene.illumination());
  LampChoice one(rooms.scene.illumination(), compiled);
  LampChoice other(rooms.scene.illumination(), compiled);
  for (int i = 0; i < 20; ++i) one.at({0.1 * i - 1.0, 1.1, 0.2});
  const ChosenLamps a = one.at({0.5, 1.1, 0.0});
  const ChosenLamps b = other.at({0.5, 1.1, 0.0});
  expectSame(a, b);
}

/// As bright as all that reaches the place would make what faces it.
double brightnessAt(const LampChoice& choice, const Coord3& place) {
  const ChosenLamps chosen = choice.at(place);
  double sum = brightness(chosen.others);
  for (const ChosenLamp& lamp : chosen.lamps) {
    const glm::vec3 away((lamp.position - place).glm());
    sum += brightness(lamp.colour * falloff(glm::dot(away, away), lamp.reach));
  }
  return sum;
}

TEST(LampChoice, WhatIsInAWallAsADoorIsHasItsLightFromBothSides) {
  const TwoRooms rooms;
  const CompiledScene compiled(rooms.scene, rooms.scene.illumination());
  const LampChoice choice(rooms.scene.illumination(), compiled);
  const double both = brightnessAt(choice, {-0.3, 1.1, 1.6}) + brightnessAt(choice, {0.3, 1.1, 1.6});
  EXPECT_GT(brightnessAt(choice, {0.0, 1.1, 1.6}), 0.5 * both);
}

TEST(LampSets, AreChosenAnewForWhatMovedAloneAndThenAsIfForAll) {
  TwoRooms rooms;
  std::vector<Box*> boxes;
  for (int i = 0; i < 300; ++i)  // more than one thread's worth
    boxes.push_back(&rooms.scene.addMoving<Box>({0.025 * i - 3.6, 1.0, 0.4}, kRed, Coord3{0.1, 0.1, 0.1}));
  CompiledScene compiled(rooms.scene, rooms.scene.illumination());
  LampSets sets(rooms.scene.illumination(), compiled);
  sets.update();
  EXPECT_EQ(sets.changed().size(), boxes.size());
  sets.update();
  EXPECT_TRUE(sets.changed().empty()) << "all rest";

  boxes[2]->setPosition(3.0, 1.0, 0.0);
  boxes[7]->rotate(TransformMatrix::rotationX(0.5));
  boxes[250]->setPosition(0.0, 1.0, 0.0);
  compiled.update();
  sets.update();
  ASSERT_EQ(sets.changed().size(), 3U);
  LampSets fresh(rooms.scene.illumination(), compiled);
  fresh.update();
  for (std::size_t i = 0; i < boxes.size(); ++i) expectSame(sets.sets()[i], fresh.sets()[i]);
}

TEST(LampSets, FollowWhatMovesAsAWholeAndNotItsJoints) {
  TwoRooms rooms;
  Box& trunk = rooms.scene.addMoving<Box>({1.5, 0.5, 0.0}, kRed, Coord3{0.4, 1.0, 0.4});
  Box arm({0.1, 0.1, 0.6});
  trunk.addMember(&arm);
  arm.setPosition(0.3, 0.3, -0.3);
  Box& far = rooms.scene.addMoving<Box>({-1.5, 0.5, 0.0}, kRed, Coord3{0.4, 1.0, 0.4});
  CompiledScene compiled(rooms.scene, rooms.scene.illumination());
  LampSets sets(rooms.scene.illumination(), compiled);
  sets.update();
  ASSERT_EQ(compiled.movingRoots().size(), 2U);
  std::array<int, 2> drawables{};
  for (const Drawable& drawable : compiled.moving().drawables) ++drawables.at(drawable.root);
  EXPECT_EQ(drawables[0] + drawables[1], 3);
  EXPECT_EQ(drawables[0] * drawables[1], 2) << "the arm belongs to the trunk";
  arm.setPosition(0.3, 0.3, 0.4);
  arm.rotate(TransformMatrix::rotationX(1.0));
  compiled.update();
  sets.update();
  EXPECT_TRUE(sets.changed().empty());
  far.setPosition(-1.4, 0.5, 0.0);
  compiled.update();
  sets.update();
  EXPECT_EQ(sets.changed().size(), 1U);
}

class MovingLight : public DrawingTest {};

TEST_F(MovingLight, IsThatOfItsOwnPlaceWhereverTheVehicleIs) {
  TwoRooms rooms;
  rooms.scene.addMoving<Box>({2.4, 0.5, 0.0}, matt(0.8, 0.8, 0.8), Coord3{0.4, 1.0, 0.4});
  rooms.scene.addMoving<Ellipsoid>({2.0, 1.2, 0.4}, matt(0.8, 0.4, 0.2), Coord3{0.3, 0.3, 0.3}, 12);
  Renderer renderer(rooms.scene, rooms.scene.illumination(), 160, 120, {.shadows = false});
  EyeView view = lookingAhead({2.2, 1.2, 2.2}, 160, 120);
  view.t_world_vehicle = TransformMatrix::translation({2.4, 0.0, 1.5});
  const Image beside = picture(renderer, {&view, 1});
  view.t_world_vehicle = TransformMatrix::translation({-2.0, 0.0, 0.0});
  EXPECT_EQ(shareDiffering(picture(renderer, {&view, 1}), beside, 0), 0.0);
}

class Shadow : public DrawingTest {};

constexpr int kWidth = 320;
constexpr int kHeight = 240;

/// A table top at y = 0 over a floor, under a lamp, with a block that moves; seen from above.
struct Table {
  Table() {
    scene.setAmbient({0.3, 0.3, 0.3}, {0.2, 0.2, 0.2});
    scene.addLight({{0.2, 2.0, 0.1}, {1.0, 1.0, 1.0}, 2.0});
    scene.add<Box>({0.0, -0.02, 0.0}, matt(0.5, 0.5, 0.5), Coord3{1.6, 0.04, 1.2});
    scene.add<Box>({0.0, -0.75, 0.0}, matt(0.5, 0.5, 0.5), Coord3{4.0, 0.1, 4.0});
    view = lookingAhead({}, kWidth, kHeight);
    view.t_world_eye =
        TransformMatrix::translation({0.0, 1.2, 0.0}) * TransformMatrix::rotationX(-0.25 * kTurn);
    view.t_world_vehicle = TransformMatrix::translation({0.0, -0.7, 0.7});
  }
  Box& block(const Coord3& at) { return scene.addMoving<Box>(at, kRed, Coord3{0.1, 0.1, 0.1}); }
  /// Places in the green picture that shadows darken, weighted by how much; red blocks shine by themselves.
  Spot darkened(const EyeView& from) const {
    const Image without = picture(scene, from, {.shadows = false});
    const Image with = picture(scene, from);
    Spot sum;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const double loss = linear(value(without, x, y, Green)) - linear(value(with, x, y, Green));
        sum.light += loss;
        sum.x += loss * (x + 0.5);
        sum.y += loss * (y + 0.5);
      }
    sum.x /= sum.light;
    sum.y /= sum.light;
    return sum;
  }
  TestScene scene;
  EyeView view;
};

Material matter() {
  return matt(0.8, 0.0, 0.0);
}

TEST_F(Shadow, OfABlockLiesBeneathItAndFollowsIt) {
  for (const Coord3& at : {Coord3{0.0, 0.4, 0.0}, Coord3{0.3, 0.4, -0.1}, Coord3{0.0, 0.6, 0.1}}) {
    Table table;
    table.block(at).setMaterial(matter());
    const Spot seen = table.darkened(table.view);
    const Coord3 below{at.x + at.y * kShadowLean.x, 0.0, at.z + at.y * kShadowLean.y};
    const Coord3 p_eye = table.view.t_world_eye.rigidInverse().point(below);
    const PixelPoint expected = projectToPixels(table.view.view, p_eye, kWidth, kHeight);
    EXPECT_GT(seen.light, 1.0);
    EXPECT_NEAR(seen.x, expected.x, 2.0);
    EXPECT_NEAR(seen.y, expected.y, 2.0);
  }
}

TEST_F(Shadow, TakesAShareOfTheLightAndNoMore) {
  Table table;
  table.block({0.0, 0.4, 0.0}).setMaterial(matter());
  const Image without = picture(table.scene, table.view, {.shadows = false});
  const Image with = picture(table.scene, table.view);
  double least = 1.0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const double before = linear(value(without, x, y, Green));
      if (before > 0.05) least = std::min(least, linear(value(with, x, y, Green)) / before);
    }
  EXPECT_LT(least, 0.75) << "it is seen";
  EXPECT_GT(least, 0.25) << "and is no hole";
}

TEST_F(Shadow, IsAtTheFootOfWhatStandsOnTheTable) {
  Table table;
  table.block({0.0, 0.05, 0.0}).setMaterial(matter());
  const Image without = picture(table.scene, table.view, {.shadows = false});
  const Image with = picture(table.scene, table.view);
  const Coord3 p_eye = table.view.t_world_eye.rigidInverse().point({-0.062, 0.0, 0.01});
  const PixelPoint foot = projectToPixels(table.view.view, p_eye, kWidth, kHeight);
  const auto at = [&](const Image& image) {
    return linear(value(image, static_cast<int>(foot.x), static_cast<int>(foot.y), Green));
  };
  EXPECT_LT(at(with), 0.9 * at(without));
}

TEST_F(Shadow, DoesNotFallThroughTheTable) {
  Table table;
  table.block({0.0, 0.4, 0.0}).setMaterial(matter());
  EyeView below = table.view;
  below.t_world_eye.setOrigin({0.0, -0.3, 0.0});
  const Image without = picture(table.scene, below, {.shadows = false});
  EXPECT_LE(shareDiffering(picture(table.scene, below), without, 1), 0.0);
}

TEST_F(Shadow, FallsOnWhatMovesTooButNotOnWhatCastsIt) {
  Table table;
  Box& lower = table.scene.addMoving<Box>({0.0, 0.1, 0.0}, matt(0.0, 0.5, 0.0), Coord3{0.4, 0.2, 0.4});
  EXPECT_GT(picture(table.scene, table.view).width, 0);
  const auto top = [&](const RendererSettings& settings) {
    const Image image = picture(table.scene, table.view, settings);
    const Coord3 p_eye = table.view.t_world_eye.rigidInverse().point({-0.1, 0.2, 0.0});
    const PixelPoint at = projectToPixels(table.view.view, p_eye, kWidth, kHeight);
    return linear(value(image, static_cast<int>(at.x), static_cast<int>(at.y), Green));
  };
  EXPECT_NEAR(top({}), top({.shadows = false}), 1e-3) << "alone it is not in its own shadow";
  const double alone = top({});
  table.block({-0.02, 0.45, -0.05}).setMaterial(matter());
  EXPECT_LT(top({}), 0.85 * alone);
  EXPECT_TRUE(lower.attribute<Moving>() != nullptr);
}

TEST_F(Shadow, RoundAndSlantingThingsHaveNoStripesOfTheirOwnShadow) {
  TestScene scene;
  scene.setAmbient({0.3, 0.3, 0.3}, {0.2, 0.2, 0.2});
  scene.addLight({{0.2, 2.0, 0.1}, {1.0, 1.0, 1.0}, 2.0});
  scene.addMoving<Ellipsoid>({-0.3, 0.0, 0.0}, matt(0.6, 0.6, 0.6), Coord3{0.4, 0.4, 0.4}, 48);
  scene.addMoving<Box>({0.3, 0.0, 0.0}, matt(0.6, 0.6, 0.6), Coord3{0.4, 0.3, 0.3})
      .setOrientation(YawPitchRoll{0.3, 0.5, 0.4});
  EyeView view = lookingAhead({}, kWidth, kHeight);
  view.t_world_eye = TransformMatrix::translation({0.0, 0.8, 0.5}) * TransformMatrix::rotationX(-1.0);
  view.t_world_vehicle = TransformMatrix::translation({0.0, -0.7, 0.7});
  const Image without = picture(scene, view, {.shadows = false});
  // Its far side, from which the lamp overhead is hidden, is in its shadow; the rest is not.
  EXPECT_LE(shareDiffering(picture(scene, view), without, 3), 0.01);
}

TEST_F(Shadow, DoesNotJumpAsTheVehicleDrives) {
  Table table;
  table.block({0.1, 0.3, 0.0}).setMaterial(matter());
  Renderer renderer(table.scene, table.scene.illumination(), kWidth, kHeight);
  Image last;
  for (int i = 0; i < 60; ++i) {
    table.view.t_world_vehicle = TransformMatrix::translation({0.013 * i, -0.7, 0.7 + 0.007 * i}) *
                                 TransformMatrix::rotationY(0.01 * i);
    const Image now = picture(renderer, {&table.view, 1});
    if (i > 0) {
      ASSERT_LE(shareDiffering(now, last, 4), 0.0) << "step " << i;
    }
    last = now;
  }
}

/// A wide floor at y = 0 with something that moves standing on it 4 m to the right, seen from above.
struct Hall {
  Hall() {
    scene.setAmbient({0.3, 0.3, 0.3}, {0.2, 0.2, 0.2});
    scene.addLight({{4.2, 2.0, 0.1}, {1.0, 1.0, 1.0}, 2.0});
    scene.add<Box>({0.0, -0.05, 0.0}, matt(0.0, 0.5, 0.0), Coord3{16.0, 0.1, 12.0});
    scene.addMoving<Box>({4.0, 0.3, 0.0}, matter(), Coord3{0.3, 0.6, 0.3});
    view = lookingAhead({}, kWidth, kHeight);
    view.t_world_eye =
        TransformMatrix::translation({4.0, 1.6, 0.0}) * TransformMatrix::rotationX(-0.25 * kTurn);
    view.t_world_vehicle = TransformMatrix::translation({0.0, 0.0, 0.0});
  }
  TestScene scene;
  EyeView view;
  const TransformMatrix there = TransformMatrix::translation({4.0, 0.0, 0.0});
};

TEST_F(Shadow, LiesBelowTheOtherVehicleTooAsItWouldBelowOnesOwn) {
  Hall hall;
  const Image without = picture(hall.scene, hall.view, {.shadows = false});
  EXPECT_LE(shareDiffering(picture(hall.scene, hall.view), without, 0), 0.0) << "nobody is there";
  hall.view.t_world_other_vehicle = hall.there;
  const Image other = picture(hall.scene, hall.view);
  EXPECT_GT(shareDiffering(other, without, 20), 0.005);
  hall.view.t_world_vehicle = TransformMatrix::translation({4.0, 0.0, 0.6});
  hall.view.t_world_other_vehicle.reset();
  EXPECT_LE(shareDiffering(picture(hall.scene, hall.view), other, 2), 0.0);
}

TEST_F(Shadow, OfTheOtherVehicleDoesNotJumpAsOneDrivesUpToIt) {
  Hall hall;
  hall.view.t_world_other_vehicle = hall.there;
  Renderer renderer(hall.scene, hall.scene.illumination(), kWidth, kHeight);
  Image last = picture(renderer, {&hall.view, 1});
  for (int i = 1; i < 60; ++i) {
    hall.view.t_world_vehicle =
        TransformMatrix::translation({4.3 - 0.061 * i, 0.0, 0.7}) * TransformMatrix::rotationY(0.02 * i);
    const Image now = picture(renderer, {&hall.view, 1});
    ASSERT_LE(shareDiffering(now, last, 4), 0.0) << "step " << i;
    last = now;
  }
}

TEST_F(Shadow, OfWhatRestsIsKeptAndOfWhatMovedIsNew) {
  Hall hall;
  hall.view.t_world_other_vehicle = hall.there;
  Box& block = hall.scene.addMoving<Box>({4.4, 0.8, 0.3}, matter(), Coord3{0.1, 0.1, 0.1});
  Renderer renderer(hall.scene, hall.scene.illumination(), kWidth, kHeight);
  const Image first = picture(renderer, {&hall.view, 1});
  EXPECT_EQ(shareDiffering(picture(renderer, {&hall.view, 1}), first, 0), 0.0);
  block.setPosition(4.1, 0.9, -0.4);
  const Image moved = picture(renderer, {&hall.view, 1});
  EXPECT_EQ(shareDiffering(moved, picture(hall.scene, hall.view), 0), 0.0) << "a new renderer's";
  block.setMaterial(kRed);  // shines: casts none
  EXPECT_EQ(shareDiffering(picture(renderer, {&hall.view, 1}), picture(hall.scene, hall.view), 0), 0.0);
  block.setPosition(4.4, 0.8, 0.3);
  block.setMaterial(matter());
  EXPECT_EQ(shareDiffering(picture(renderer, {&hall.view, 1}), first, 0), 0.0);
}

TEST_F(Shadow, IsLookedForOnlyWhereItCanBe) {
  TestScene scene;
  scene.addLight({{0.0, 2.5, 0.0}, {1.0, 1.0, 1.0}, 3.0});
  for (int i = 0; i < 6; ++i)
    scene.add<Box>({4.0 * i, -1.05, 0.0}, matt(0.5, 0.5, 0.5), Coord3{3.9, 0.1, 3.9});  // each a block
  scene.add<Rectangle>({0.0, 0.0, -1.0}, matt(0.5, 0.5, 0.5), 2.0,
                       2.0);  // a wall: what is overhead does not shade it
  Box& block = scene.addMoving<Box>({0.0, -0.5, 0.0}, kRed, Coord3{0.1, 0.1, 0.1});
  block.setMaterial(matter());
  Renderer renderer(scene, scene.illumination(), kWidth, kHeight, {.clip = false});
  EyeView view = lookingAhead({}, kWidth, kHeight);
  const auto counts = [&](double vehicle_x) {
    view.t_world_vehicle = TransformMatrix::translation({vehicle_x, -1.0, 0.7});
    renderer.draw({&view, 1});
    return renderer.counts();
  };
  EXPECT_EQ(counts(0.0).fixed_shaded, 1U);
  EXPECT_EQ(counts(0.0).fixed_plain, 6U);
  EXPECT_EQ(counts(0.0).moving, 1U);
  EXPECT_EQ(counts(30.0).fixed_shaded, 0U) << "the vehicle is elsewhere";
  block.setPosition(2.0, -0.5, 0.0);
  EXPECT_EQ(counts(2.0).fixed_shaded, 2U) << "across a joint";
}

TEST_F(Shadow, TwoRenderersDrawTheSamePicture) {
  Table table;
  table.block({0.1, 0.3, 0.0}).setMaterial(matter());
  const Image first = picture(table.scene, table.view);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(shareDiffering(picture(table.scene, table.view), first, 0), 0.0);
}

}  // namespace
}  // namespace coherency
