#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/Frustum.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

constexpr double kNear = 0.05;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Clip {
  double x, y, z, w;
};

Clip clipOf(const TransformMatrix& p, const Coord3& point) {
  const auto row = [&](int r) { return p(r, 0) * point.x + p(r, 1) * point.y + p(r, 2) * point.z + p(r, 3); };
  return {row(0), row(1), row(2), row(3)};
}

double depthAt(const TransformMatrix& p, double distance) {
  const Clip clip = clipOf(p, {0.0, 0.0, -distance});
  return clip.z / clip.w;
}

FieldOfView randomView() {
  const double left = random::real(-0.5, 2.0);
  const double down = random::real(-0.5, 2.0);
  return {left, random::real(-left + 0.1, 3.0), down, random::real(-down + 0.1, 3.0)};
}

TEST(Frustum, DepthIsOneAtTheNearPlaneAndFallsToZeroAtInfinity) {
  const TransformMatrix p = projection({}, kNear);
  EXPECT_DOUBLE_EQ(depthAt(p, kNear), 1.0);
  EXPECT_DOUBLE_EQ(depthAt(p, 2.0 * kNear), 0.5);
  double last = 1.0;
  for (double distance = 2.0 * kNear; distance < 1e12; distance *= 2.0) {
    const double depth = depthAt(p, distance);
    EXPECT_LT(depth, last);
    EXPECT_GT(depth, 0.0);
    last = depth;
  }
  EXPECT_LT(last, 1e-12);
}

TEST(Frustum, FloatDepthTellsMillimetresApartAtTenMetres) {
  const TransformMatrix p = projection({}, 0.01);
  EXPECT_NE(static_cast<float>(depthAt(p, 10.0)), static_cast<float>(depthAt(p, 10.001)));
  EXPECT_NE(static_cast<float>(depthAt(p, 10000.0)), static_cast<float>(depthAt(p, 10001.0)));
}

RC_GTEST_PROP(Frustum, TheEdgesOfTheViewAreTheEdgesOfTheImage, ()) {
  const FieldOfView view = randomView();
  const double distance = random::real(0.1, 1000.0);
  const TransformMatrix p = projection(view, kNear);
  const Clip low = clipOf(p, Coord3{-view.tan_left, -view.tan_down, -1.0} * distance);
  const Clip high = clipOf(p, Coord3{view.tan_right, view.tan_up, -1.0} * distance);
  RC_ASSERT(std::abs(low.x / low.w + 1.0) < 1e-12);
  RC_ASSERT(std::abs(low.y / low.w + 1.0) < 1e-12);
  RC_ASSERT(std::abs(high.x / high.w - 1.0) < 1e-12);
  RC_ASSERT(std::abs(high.y / high.w - 1.0) < 1e-12);
}

RC_GTEST_PROP(Frustum, PixelsAgreeWithTheProjectionMatrix, ()) {
  const FieldOfView view = randomView();
  const int width = *rc::gen::inRange(1, 4000);
  const int height = *rc::gen::inRange(1, 4000);
  const Coord3 point{random::real(-50.0, 50.0), random::real(-50.0, 50.0), -random::real(0.1, 100.0)};
  const Clip clip = clipOf(projection(view, kNear), point);
  const PixelPoint pixel = projectToPixels(view, point, width, height);
  const double x = (clip.x / clip.w + 1.0) / 2.0 * width;
  const double y = (1.0 - clip.y / clip.w) / 2.0 * height;
  RC_ASSERT(std::abs(pixel.x - x) < 1e-9 * (1.0 + std::abs(x)));
  RC_ASSERT(std::abs(pixel.y - y) < 1e-9 * (1.0 + std::abs(y)));
}

TEST(Frustum, PixelsCountFromTheTopLeft) {
  const FieldOfView view{1.0, 1.0, 0.75, 0.75};
  const PixelPoint corner = projectToPixels(view, {-2.0, 1.5, -2.0}, 640, 480);
  EXPECT_DOUBLE_EQ(corner.x, 0.0);
  EXPECT_DOUBLE_EQ(corner.y, 0.0);
  const PixelPoint middle = projectToPixels(view, {0.0, 0.0, -2.0}, 640, 480);
  EXPECT_DOUBLE_EQ(middle.x, 320.0);
  EXPECT_DOUBLE_EQ(middle.y, 240.0);
}

/// Two eyes `ipd` apart that look parallel see a point at depth z shifted by focal length * ipd / z.
TEST(Frustum, DisparityIsThatOfTriangulation) {
  constexpr double kIpd = 0.064;
  constexpr int kWidth = 640;
  const FieldOfView left_eye{1.2, 0.8, 0.75, 0.75};
  const FieldOfView right_eye{0.8, 1.2, 0.75, 0.75};
  for (const double depth : {0.5, 1.0, 5.0}) {
    const Coord3 point{0.03, 0.02, -depth};
    const PixelPoint left = projectToPixels(left_eye, point + Coord3{kIpd / 2.0, 0.0, 0.0}, kWidth, 480);
    const PixelPoint right = projectToPixels(right_eye, point - Coord3{kIpd / 2.0, 0.0, 0.0}, kWidth, 480);
    const double axis_left = projectToPixels(left_eye, {0.0, 0.0, -1.0}, kWidth, 480).x;
    const double axis_right = projectToPixels(right_eye, {0.0, 0.0, -1.0}, kWidth, 480).x;
    const double focal_length_px = kWidth / 2.0;  // the tangents of each eye sum to 2
    EXPECT_NEAR((left.x - axis_left) - (right.x - axis_right), focal_length_px * kIpd / depth, 1e-9) << depth;
    EXPECT_DOUBLE_EQ(left.y, right.y);
  }
}

TEST(Frustum, DegreesBecomeTangents) {
  const FieldOfView view = fieldOfViewFromDegrees(45.0, 30.0, 60.0, -10.0);
  EXPECT_NEAR(view.tan_left, 1.0, 1e-15);
  EXPECT_NEAR(view.tan_right, std::sqrt(1.0 / 3.0), 1e-15);
  EXPECT_NEAR(view.tan_down, std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(view.tan_up, -0.17632698070846498, 1e-15);
}

void expectRefused(double left, double right, double down, double up, const std::string& named) {
  try {
    fieldOfViewFromDegrees(left, right, down, up);
    FAIL() << "accepted " << left << ' ' << right << ' ' << down << ' ' << up;
  } catch (const std::domain_error& error) {
    EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
  }
}

TEST(Frustum, RefusesImpossibleViewsAndNamesTheAngle) {
  expectRefused(90.0, 45.0, 45.0, 45.0, "angle left");
  expectRefused(45.0, -90.0, 45.0, 45.0, "angle right");
  expectRefused(45.0, 45.0, kNan, 45.0, "angle down");
  expectRefused(45.0, 45.0, 45.0, 120.0, "angle up");
  expectRefused(-30.0, 30.0, 45.0, 45.0, "left and right");
  expectRefused(45.0, 45.0, -40.0, 30.0, "down and up");
}

TEST(Frustum, RefusesAnEmptyImageAndANearPlaneBehindTheEye) {
  EXPECT_THROW(projection({1.0, -1.0, 1.0, 1.0}, kNear), std::domain_error);
  EXPECT_THROW(projection({1.0, 1.0, -2.0, 1.0}, kNear), std::domain_error);
  EXPECT_THROW(projection({kNan, 1.0, 1.0, 1.0}, kNear), std::domain_error);
  for (const double near_m : {0.0, -0.1, kNan, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(projection({}, near_m), std::domain_error) << near_m;
}

}  // namespace
}  // namespace coherency
