// Pictures with block clipping, of colours and of objects' numbers, are those without it, whatever the scene.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/render/Support.h"

namespace coherency {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 48;

class Clip : public DrawingTest {
 protected:
  double between(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  Coord3 within(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }
  double magnitude(double low, double high) { return std::pow(10.0, between(low, high)); }

  /// Turned, stretched, sheared, one in three mirrored; about the origin, which is where the eye is.
  TransformMatrix anyTransform() {
    TransformMatrix t = TransformMatrix::translation(within(magnitude(-1.0, 1.0)));
    t = t * TransformMatrix::rotation(within(1.0) + Coord3{0.0, 2.0, 0.0}, between(0.0, 6.0));
    t(0, 1) += between(-1.0, 1.0);
    return t * TransformMatrix::scaling({(between(0.0, 3.0) < 1.0 ? -1.0 : 1.0) * magnitude(-1.0, 0.7),
                                         magnitude(-1.0, 0.7), magnitude(-1.0, 0.7)});
  }

  EyeView anyView() {
    EyeView view = lookingAhead({}, kWidth, kHeight);
    view.t_world_eye = TransformMatrix::translation(within(0.5)) *
                       TransformMatrix::rotation(within(1.0) + Coord3{0.0, 2.0, 0.0}, between(0.0, 6.0));
    const auto side = [&] { return std::tan(between(0.05, 89.9) * std::numbers::pi / 180.0); };
    view.view = {side(), side(), side(), side()};
    view.near_m = magnitude(-3.0, 0.0);
    return view;
  }

  /// A colour that no other of a few thousand things has: one sees which it is.
  static Material numbered(int number) {
    return glow((number % 16 + 1) / 16.0, (number / 16 % 16 + 1) / 16.0, (number / 256 % 16 + 1) / 16.0);
  }

  /// Boxes have sides of 1 m.
  static bool eyeIsInABox(const EyeView& view, const std::vector<VRObject*>& boxes) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const VRObject* box) {
      const Coord3 eye = box->globalTransform().inverse().point(view.t_world_eye.origin());
      return std::max({std::abs(eye.x), std::abs(eye.y), std::abs(eye.z)}) < 0.5;
    });
  }

 private:
  std::mt19937_64 engine_{7};
};

constexpr RendererSettings kClipped{.samples = 1, .shadows = false};
constexpr RendererSettings kWhole{.samples = 1, .shadows = false, .clip = false};

TEST_F(Clip, LeavesThePictureOfWhatMovesAsItIs) {
  constexpr int kObjects = 24;
  TestScene scene;
  std::vector<VRObject*> objects;
  for (int i = 0; i < kObjects; ++i) {
    Box& box = scene.addMoving<Box>({}, numbered(10 * i), Coord3{1.0, 1.0, 1.0});
    objects.push_back(&box);
    // Half of them in chains of four and of eight, each in the frame of the one before.
    if (i % 8 >= 4 || i > 16) {
      scene.removeMember(&box);
      objects[static_cast<std::size_t>(i) - 1]->addMember(&box);
    }
  }
  Renderer clipped(scene, scene.illumination(), kWidth, kHeight, kClipped);
  Renderer whole(scene, scene.illumination(), kWidth, kHeight, kWhole);
  std::size_t left_out = 0;
  int inside = 0;
  for (int i = 0; i < 10'000; ++i) {
    for (VRObject* object : objects) object->setTransform(anyTransform());
    const EyeView view = anyView();
    ASSERT_TRUE(sameDrawn(clipped, whole, {&view, 1})) << "scene " << i;
    left_out += whole.counts().moving - clipped.counts().moving;
    inside += eyeIsInABox(view, objects) ? 1 : 0;
  }
  EXPECT_GT(left_out, 10'000U * kObjects / 4) << "or it is of no use";
  EXPECT_GT(inside, 200) << "eyes are to be inside of objects, too";
}

TEST_F(Clip, LeavesThePictureOfWhatNeverMovesAsItIs) {
  for (int i = 0; i < 60; ++i) {
    TestScene scene;
    for (int k = 0; k < 40; ++k)
      scene.add<Box>({}, numbered(6 * k), Coord3{1.0, 1.0, 1.0}).setTransform(anyTransform());
    Renderer clipped(scene, scene.illumination(), kWidth, kHeight, kClipped);
    Renderer whole(scene, scene.illumination(), kWidth, kHeight, kWhole);
    for (int k = 0; k < 10; ++k) {
      const EyeView view = anyView();
      ASSERT_TRUE(sameDrawn(clipped, whole, {&view, 1})) << "scene " << i;
    }
  }
}

TEST_F(Clip, LeavesShadowsAndLampsAsTheyAre) {
  constexpr RendererSettings kShadows{.samples = 1, .shadow_resolution = 128};
  RendererSettings all = kShadows;
  all.clip = false;
  TestScene scene;
  scene.setAmbient({0.3, 0.3, 0.3}, {0.1, 0.1, 0.1});
  for (const double x : {-2.0, 0.5, 3.0}) scene.addLight({{x, 2.0, -1.0}, {1.0, 1.0, 1.0}, 2.0});
  scene.add<Box>({0.0, -1.05, 0.0}, matt(0.8, 0.8, 0.7), Coord3{12.0, 0.1, 12.0});
  std::vector<VRObject*> blocks;
  for (int i = 0; i < 8; ++i)
    blocks.push_back(&scene.addMoving<Box>({}, matt(0.2 + 0.1 * i, 0.5, 0.4), Coord3{0.3, 0.3, 0.3}));
  Renderer clipped(scene, scene.illumination(), kWidth, kHeight, kShadows);
  Renderer whole(scene, scene.illumination(), kWidth, kHeight, all);
  for (int i = 0; i < 300; ++i) {
    for (VRObject* block : blocks)
      block->setTransform(
          TransformMatrix::translation({between(-4.0, 4.0), between(-0.9, 1.0), between(-4.0, 4.0)}));
    EyeView view = anyView();
    view.t_world_vehicle = TransformMatrix::translation({between(-1.0, 1.0), -1.0, between(-1.0, 1.0)});
    view.t_world_other_vehicle = TransformMatrix::translation({between(-4.0, 4.0), -1.0, between(-4.0, 4.0)});
    ASSERT_TRUE(sameDrawn(clipped, whole, {&view, 1})) << i;
  }
}

TEST_F(Clip, TwoViewsOfAFrameEachHaveWhatTheySee) {
  TestScene scene;
  scene.add<Box>({-5.0, 0.0, 0.0}, kRed, Coord3{1.0, 1.0, 1.0});
  scene.addMoving<Box>({5.0, 0.0, 0.0}, kGreen, Coord3{1.0, 1.0, 1.0});
  std::vector<EyeView> views(2, lookingAhead({}, kWidth, kHeight));
  views[0].t_world_eye = TransformMatrix::rotationY(std::numbers::pi / 2.0);
  views[1].t_world_eye = TransformMatrix::rotationY(-std::numbers::pi / 2.0);
  views[1].x = kWidth;
  Renderer renderer(scene, scene.illumination(), 2 * kWidth, kHeight, kClipped);
  const Image both = picture(renderer, views);
  EXPECT_GT(spot(both, Red, 0, kWidth).light, 0.0);
  EXPECT_EQ(spot(both, Green, 0, kWidth).light, 0.0);
  EXPECT_GT(spot(both, Green, kWidth, 2 * kWidth).light, 0.0);
  EXPECT_EQ(spot(both, Red, kWidth, 2 * kWidth).light, 0.0);
}

}  // namespace
}  // namespace coherency
