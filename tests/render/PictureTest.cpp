// What stands where in a picture, and which of its sides shows.

#include "common/math/FixedPoint.h"
#include "tests/render/Support.h"

namespace coherency {
namespace {

class Picture : public DrawingTest {};

constexpr int kWidth = 160;
constexpr int kHeight = 120;

TEST_F(Picture, IsNeitherUpsideDownNorMirrored) {
  TestScene scene;
  scene.add<Box>({0.0, 0.4, -2.0}, kRed, Coord3{0.2, 0.2, 0.2});
  scene.add<Box>({0.0, -0.6, -2.0}, kBlue, Coord3{0.2, 0.2, 0.2});
  scene.add<Box>({0.8, 0.0, -2.0}, kGreen, Coord3{0.2, 0.2, 0.2});
  const EyeView view = lookingAhead({}, kWidth, kHeight);
  const Image image = picture(scene, view);
  const auto expectAt = [&](Channel channel, const Coord3& middle) {
    const PixelPoint expected = projectToPixels(view.view, middle, kWidth, kHeight);
    const Spot seen = spot(image, channel);
    EXPECT_NEAR(seen.x, expected.x, 1.5);
    EXPECT_NEAR(seen.y, expected.y, 1.5);
  };
  expectAt(Red, {0.0, 0.4, -2.0});
  expectAt(Blue, {0.0, -0.6, -2.0});
  expectAt(Green, {0.8, 0.0, -2.0});
  EXPECT_LT(spot(image, Red).y, spot(image, Blue).y) << "row 0 is the top";
  EXPECT_GT(spot(image, Green).x, spot(image, Red).x);
}

TEST_F(Picture, ViewsLieWhereTheyAreToldCountedFromTheBottomLeft) {
  TestScene scene;
  scene.add<Rectangle>({0.0, 0.0, -1.0}, kRed, 10.0, 10.0);
  EyeView view = lookingAhead({}, 30, 20);
  view.x = 50;
  view.y = 60;
  Renderer renderer(scene, scene.illumination(), kWidth, kHeight);
  const Image image = picture(renderer, {&view, 1});
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const int row_from_below = kHeight - 1 - y;
      const bool inside = x >= 50 && x < 80 && row_from_below >= 60 && row_from_below < 80;
      ASSERT_EQ(value(image, x, y, Red) > 0, inside) << x << ", " << y;
    }
}

TEST_F(Picture, ShowsWhatIsBeyondTheNearPlaneHoweverFar) {
  TestScene scene;
  Rectangle& face = scene.addMoving<Rectangle>({0.0, 0.0, 0.0}, kRed, 1.0, 1.0);
  Renderer renderer(scene, scene.illumination(), kWidth, kHeight);
  const EyeView view = lookingAhead({}, kWidth, kHeight);
  const auto seen = [&](double distance) {
    face.setTransform(TransformMatrix::translation({0.0, 0.0, -distance}) *
                      TransformMatrix::scaling(Coord3{1.0, 1.0, 1.0} * (4.0 * distance)));
    return value(picture(renderer, {&view, 1}), kWidth / 2, kHeight / 2, Red) > 0;
  };
  EXPECT_FALSE(seen(0.0099));
  EXPECT_TRUE(seen(0.0101));
  EXPECT_TRUE(seen(1e3));
  EXPECT_TRUE(seen(1e9));
}

TEST_F(Picture, FacesShowOnlyFromOutside) {
  TestScene scene;
  Rectangle& face = scene.addMoving<Rectangle>({0.0, 0.0, -2.0}, kRed, 1.0, 1.0);
  Renderer renderer(scene, scene.illumination(), kWidth, kHeight);
  const EyeView view = lookingAhead({}, kWidth, kHeight);
  const auto seen = [&](const TransformMatrix& linear) {
    face.setOrientation(linear);
    return spot(picture(renderer, {&view, 1}), Red).light > 0.0;
  };
  const TransformMatrix back = TransformMatrix::rotationY(0.5 * kTurn);
  const TransformMatrix mirrored = TransformMatrix::scaling({-1.0, 1.0, 1.0});
  EXPECT_TRUE(seen(TransformMatrix()));
  EXPECT_FALSE(seen(back));
  EXPECT_TRUE(seen(mirrored)) << "mirroring in x does not turn a face away";
  EXPECT_FALSE(seen(back * mirrored));
  EXPECT_FALSE(seen(TransformMatrix::scaling({1.0, 1.0, -1.0}))) << "mirroring in its own normal does";
  EXPECT_FALSE(seen(TransformMatrix::scaling({0.0, 1.0, 1.0}))) << "flat: nothing to see, and no error";
}

/// Upright and mirrored shapes among one another, over a floor they throw their shadows on; all of them are
/// symmetric, so that mirroring must change nothing at all.
void buildSymmetric(TestScene& scene, double x_scale, bool moving) {
  scene.setAmbient({0.3, 0.3, 0.35}, {0.1, 0.1, 0.1});
  scene.addLight({{0.5, 2.5, -1.5}, {1.0, 1.0, 1.0}, 4.0});
  scene.add<Box>({0.0, -1.05, -3.0}, matt(0.7, 0.7, 0.7), Coord3{6.0, 0.1, 6.0});
  const TransformMatrix turned =
      TransformMatrix::rotationY(0.6) * TransformMatrix::scaling({x_scale, 1.0, 1.0});
  const auto place = [&](VRObject& object, const TransformMatrix& linear) {
    object.setOrientation(linear);
    if (moving) object.attach(Moving{});
  };
  place(scene.add<Box>({-0.7, -0.4, -3.0}, matt(0.8, 0.3, 0.2), Coord3{0.6, 0.8, 0.4}), turned);
  place(
      scene.add<Ellipsoid>({0.6, -0.5, -2.5}, Material{{0.2, 0.5, 0.8}, 0.6, 0.0}, Coord3{0.4, 0.3, 0.5}, 24),
      turned);
  place(scene.add<Rectangle>({0.1, 0.2, -2.0}, matt(0.8, 0.8, 0.2), 0.5, 0.3),
        TransformMatrix::rotationX(-0.25 * kTurn) * TransformMatrix::scaling({x_scale, 1.0, 1.0}));
  place(scene.add<Cylinder>({0.1, -0.4, -3.8}, matt(0.3, 0.7, 0.3), 0.4, 1.2, 24), {});
}

TEST_F(Picture, MirroredShapesShowTheirOutsideLitAndShadowingAsUprightOnes) {
  for (const bool moving : {false, true}) {
    TestScene upright;
    TestScene mirrored;
    buildSymmetric(upright, 1.0, moving);
    buildSymmetric(mirrored, -1.0, moving);
    EyeView view = lookingAhead({}, 320, 240);
    view.t_world_vehicle = TransformMatrix::translation({0.0, -1.0, -2.5});
    const Image expected = picture(upright, view);
    // Light between vertices depends a little on which way a face's diagonal runs.
    EXPECT_LE(shareDiffering(picture(mirrored, view), expected, 4), 0.004) << "moving: " << moving;
    if (!moving) continue;
    EXPECT_GT(shareDiffering(picture(upright, view, {.shadows = false}), expected, 8), 0.01)
        << "there are shadows";
  }
}

TEST_F(Picture, ShapesMayLieFarFromTheirOwnFrame) {
  const auto seen = [](double away) {
    TestScene scene;
    const auto corner = [&](double x, double y) { return Coord3{away + x, y, -2.0 - away}; };
    scene.add<Polygon>({-away, 0.0, away}, kRed,
                       std::vector{corner(0.1, 0.2), corner(0.9, 0.3), corner(0.8, 0.7), corner(0.2, 0.6)});
    return picture(scene, lookingAhead({}, kWidth, kHeight));
  };
  const Image near = seen(0.0);
  EXPECT_GT(spot(near, Red).x, kWidth / 2) << "to the right and above";
  EXPECT_LT(spot(near, Red).y, kHeight / 2);
  EXPECT_LE(shareDiffering(seen(1e6), near, 2), 0.001);
}

TEST_F(Picture, FollowsWhatMovesAndChangesBetweenFrames) {
  TestScene scene;
  VRObject& group = scene.addMoving<Box>({0.0, 0.0, -2.0}, kBlue, Coord3{0.01, 0.01, 0.01});
  Box child({0.1, 0.1, 0.1});
  child.setMaterial(kRed);
  group.addMember(&child);
  Renderer renderer(scene, scene.illumination(), kWidth, kHeight);
  const EyeView view = lookingAhead({}, kWidth, kHeight);
  for (const Coord3& at : {Coord3{0.0, 0.0, -2.0}, Coord3{0.7, 0.3, -1.5}, Coord3{-0.9, -0.5, -3.0}}) {
    group.setPosition(at + Coord3{0.1, 0.0, 0.0});
    child.setPosition(-0.1, 0.0, 0.0);
    const Spot seen = spot(picture(renderer, {&view, 1}), Red);
    const PixelPoint expected = projectToPixels(view.view, at, kWidth, kHeight);
    EXPECT_NEAR(seen.x, expected.x, 1.0);
    EXPECT_NEAR(seen.y, expected.y, 1.0);
  }
  child.setMaterial(kGreen);
  const Image green = picture(renderer, {&view, 1});
  EXPECT_EQ(spot(green, Red).light, 0.0);
  EXPECT_GT(spot(green, Green).light, 0.0);
}

TEST_F(Picture, EyeMovesThePictureTheOtherWay) {
  TestScene scene;
  scene.add<Ellipsoid>({0.2, 1.6, -2.0}, kRed, Coord3{0.05, 0.05, 0.05});
  Renderer renderer(scene, scene.illumination(), kWidth, kHeight);
  EyeView view = lookingAhead({}, kWidth, kHeight);
  for (const double yaw : {0.0, 0.4, -0.3}) {
    view.t_world_eye =
        TransformMatrix::translation({0.0, 1.4, 0.3}) * rotation(YawPitchRoll{yaw, 0.1, 0.5 * yaw});
    const Spot seen = spot(picture(renderer, {&view, 1}), Red);
    const Coord3 p_eye = view.t_world_eye.rigidInverse().point({0.2, 1.6, -2.0});
    const PixelPoint expected = projectToPixels(view.view, p_eye, kWidth, kHeight);
    EXPECT_NEAR(seen.x, expected.x, 0.2);
    EXPECT_NEAR(seen.y, expected.y, 0.2);
  }
}

}  // namespace
}  // namespace coherency
