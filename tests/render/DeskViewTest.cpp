// A screen on the desk is a window: what lies in its plane keeps its pixel wherever the eye is, what lies
// behind it is seen along a straight line, and turning the head changes nothing.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "render_client/draw/EyeViews.h"
#include "tests/math/Random.h"
#include "tests/render/Seated.h"

namespace coherency {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;

HmdProfile desk() {
  HmdProfile hmd;
  hmd.screen = Screen{0.64, 0.36, 0.6, -0.15, 0.2};
  return hmd;
}

/// From the screen to the world, from the words in docs/displays.md: its middle `distance` ahead of the eyes
/// of somebody who sits upright, `above` over them, its top tilted away.
TransformMatrix worldToScreen(const Scene& scene, const Screen& screen) {
  const Rig& rig = scene.human().rig();
  const double eyes_up = rig.seat_height + rig.trunk_length + rig.neck_length + rig.eye_up;
  const double eyes_ahead = rig.neck_back + rig.eye_forward;
  const double c = std::cos(screen.tilt_rad);
  const double s = std::sin(screen.tilt_rad);
  return scene.human().globalTransform() *
         TransformMatrix::fromAxes({1.0, 0.0, 0.0}, {0.0, c, -s}, {0.0, s, c},
                                   {0.0, eyes_up + screen.above_m, -eyes_ahead - screen.distance_m});
}

EyeView viewOf(const Scene& scene, EyeChoice eye, const HmdProfile& hmd = desk()) {
  std::vector<EyeView> views;
  eyeViews(scene, Mode::Operator, hmd, eye, kWidth, kHeight, views);
  return views.front();
}

PixelPoint pixelOf(const EyeView& view, const Coord3& p_world) {
  return projectToPixels(view.view, view.t_world_eye.rigidInverse().point(p_world), view.width, view.height);
}

EyeChoice anyEye() {
  return *rc::gen::element(EyeChoice::Left, EyeChoice::Right, EyeChoice::Mono);
}

Seat anySeat() {
  Seat seat;
  seat.lean = random::vector(0.25);
  seat.turn = {random::real(-1.2, 1.2), random::real(-1.0, 1.0), random::real(-0.5, 0.5)};
  seat.base = {1'500'000'000, 0, -2'000'000'000, 0x2000'0000};
  return seat;
}

RC_GTEST_PROP(DeskView, APointInTheScreensPlaneKeepsItsPixelWhateverTheHeadDoes, ()) {
  SeenScene scene;
  sit(scene, anySeat());
  const double right = random::real(-0.32, 0.32);
  const double up = random::real(-0.18, 0.18);
  const Coord3 p_world = worldToScreen(scene, *desk().screen).point({right, up, 0.0});
  const PixelPoint at = pixelOf(viewOf(scene, anyEye()), p_world);
  RC_ASSERT(std::abs(at.x - kWidth * (0.5 + right / 0.64)) < 1e-4);
  RC_ASSERT(std::abs(at.y - kHeight * (0.5 - up / 0.36)) < 1e-4);
}

RC_GTEST_PROP(DeskView, WhatIsBehindTheScreenIsWhereTheLineToItCrossesTheScreen, ()) {
  SeenScene scene;
  sit(scene, anySeat());
  const EyeChoice choice = anyEye();
  const Eye eye = choice == EyeChoice::Left ? Eye::Left : choice == EyeChoice::Right ? Eye::Right : Eye::Mono;
  const TransformMatrix t_world_screen = worldToScreen(scene, *desk().screen);
  const Coord3 from =
      t_world_screen.rigidInverse().point(scene.eye(eye, Mode::Operator).globalTransform().origin());
  RC_PRE(from.z > kNearestToScreen);
  const Coord3 to{random::real(-3.0, 3.0), random::real(-3.0, 3.0), random::real(-5.0, -0.1)};
  const Coord3 crossed = from + from.z / (from.z - to.z) * (to - from);
  const PixelPoint at = pixelOf(viewOf(scene, choice), t_world_screen.point(to));
  RC_ASSERT(std::abs(at.x - kWidth * (0.5 + crossed.x / 0.64)) < 1e-4);
  RC_ASSERT(std::abs(at.y - kHeight * (0.5 - crossed.y / 0.36)) < 1e-4);
}

TEST(DeskView, TurningTheHeadAboutTheEyeTurnsNothingAndMovingItDoes) {
  SeenScene scene;
  sit(scene, {});
  const EyeView straight = viewOf(scene, EyeChoice::Mono);
  sit(scene, {{}, {0.8, 0.4, 0.3}, {}});
  const EyeView turned = viewOf(scene, EyeChoice::Mono);
  EXPECT_TRUE(straight.t_world_eye.linear() == turned.t_world_eye.linear());
  sit(scene, {{0.1, 0.0, 0.0}, {}, {}});
  const EyeView moved = viewOf(scene, EyeChoice::Mono);
  EXPECT_NEAR(moved.view.tan_left - straight.view.tan_left, 0.1 / 0.6, 0.02);
  EXPECT_NEAR(moved.view.tan_right - straight.view.tan_right, -0.1 / 0.6, 0.02);
}

TEST(DeskView, AnEyeInTheScreenOrBehindItIsTakenToBeALittleBeforeIt) {
  SeenScene scene;
  for (const double ahead : {-0.56, -0.6, -0.75}) {
    sit(scene, {{0.0, 0.0, ahead}, {}, {}});
    const EyeView view = viewOf(scene, EyeChoice::Mono);
    const Coord3 eye = worldToScreen(scene, *desk().screen).rigidInverse().point(view.t_world_eye.origin());
    EXPECT_NEAR(eye.z, kNearestToScreen, 1e-9);
    EXPECT_NEAR(view.view.tan_left + view.view.tan_right, 0.64 / kNearestToScreen, 1e-9);
  }
}

TEST(DeskView, APictureOfAnotherShapeHasSquarePixelsOverTheScreensWidth) {
  SeenScene scene;
  sit(scene, {});
  std::vector<EyeView> views;
  for (const auto& [width, height] : {std::pair{640, 480}, {300, 900}}) {
    eyeViews(scene, Mode::Operator, desk(), EyeChoice::Both, width, height, views);
    for (const EyeView& eye : views)
      EXPECT_NEAR((eye.view.tan_left + eye.view.tan_right) / width,
                  (eye.view.tan_down + eye.view.tan_up) / height, 1e-12);
  }
}

/// A robot of half the size sees through a window of half the size at half the distance: as much of itself.
TEST(DeskView, ARobotsScreenIsOfItsSize) {
  SceneDescription description;
  description.name = "test";
  description.robot = RobotPlacement{basePose(-2.0, -1.0, 0.3), basePose(0.0, -2.0, 0.0)};
  Rig rig;
  rig.robot_scale = 0.5;
  Scene scene(description, rig);
  sit(scene, {});
  std::vector<EyeView> own;
  std::vector<EyeView> robots;
  eyeViews(scene, Mode::Operator, desk(), EyeChoice::Left, kWidth, kHeight, own);
  eyeViews(scene, Mode::Robot, desk(), EyeChoice::Left, kWidth, kHeight, robots);
  for (const auto side :
       {&FieldOfView::tan_left, &FieldOfView::tan_right, &FieldOfView::tan_down, &FieldOfView::tan_up})
    EXPECT_NEAR(robots[0].view.*side, own[0].view.*side, 1e-6);
  EXPECT_LT(
      norm(robots[0].t_world_eye.origin() - scene.eye(Eye::Left, Mode::Robot).globalTransform().origin()),
      1e-9);
}

}  // namespace
}  // namespace coherency
