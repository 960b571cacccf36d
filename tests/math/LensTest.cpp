// A lens's curve rises and has an inverse, or is refused; what it shows is all within its field of view.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/Lens.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

LensCurve curve(double c1, double c2, double c3 = 0.0, double c4 = 0.0, bool reciprocal = false) {
  return {{1.0, c1, c2, c3, c4}, reciprocal};
}

LensCurve randomCurve() {
  return {{random::real(0.5, 2.0), random::real(-0.6, 0.6), random::real(-0.4, 0.4), random::real(-0.2, 0.2),
           random::real(-0.1, 0.1)},
          *rc::gen::arbitrary<bool>()};
}

/// The smallest slope of many; -1 where the curve is not finite.
double leastSlope(const LensCurve& c, double end) {
  double least = c.slope(0.0);
  for (double r = 0.0; r <= end; r += end / 20'000)
    least = std::min(least, c.tangent(r) >= 0.0 ? c.slope(r) : -1.0);
  return least;
}

TEST(LensCurve, IsThePublishedPolynomial) {
  const LensCurve rift = curve(0.22, 0.24);
  EXPECT_DOUBLE_EQ(rift.tangent(0.5), 0.5 * (1.0 + 0.22 * 0.25 + 0.24 * 0.0625));
  const LensCurve vive = curve(-0.2, -0.05, -0.02, 0.0, true);
  EXPECT_DOUBLE_EQ(vive.tangent(0.5), 0.5 / (1.0 - 0.2 * 0.25 - 0.05 * 0.0625 - 0.02 * 0.015625));
}

RC_GTEST_PROP(LensCurve, SlopeIsThatOfTheTangent, ()) {
  const LensCurve c = randomCurve();
  const double r = random::real(0.01, 0.8);
  RC_PRE(c.risesUpTo(0.9));
  const double step = 1e-6;
  const double measured = (c.tangent(r + step) - c.tangent(r - step)) / (2.0 * step);
  RC_ASSERT(std::abs(measured - c.slope(r)) < 1e-6 * (1.0 + std::abs(measured)));
}

RC_GTEST_PROP(LensCurve, RisesOrIsRefused, ()) {
  const LensCurve c = randomCurve();
  const double end = random::real(0.1, 2.0);
  const double least = leastSlope(c, end);
  if (least <= 0.0) RC_ASSERT(!c.risesUpTo(end));
  if (least > 1e-4) RC_ASSERT(c.risesUpTo(end));  // so much that none falls between two of them
}

TEST(LensCurve, ADipTooNarrowForSamplesIsFound) {
  // (q - 1)^2 - 1e-9 about q = r^2 = 1, as the slope: s + 2 q s' = sum of (1 + 2 i) c_i q^i.
  const double dip = 1e-9;
  LensCurve c{{1.0 - dip, -2.0 / 3.0, 1.0 / 5.0, 0.0, 0.0}, false};
  EXPECT_LT(c.slope(1.0), 0.0);
  EXPECT_FALSE(c.risesUpTo(2.0));
  c.c[0] = 1.0 + dip;
  EXPECT_TRUE(c.risesUpTo(2.0));
}

TEST(LensCurve, WhatIsNotANumberIsRefused) {
  EXPECT_FALSE(curve(NAN, 0.0).risesUpTo(1.0));
  EXPECT_FALSE(curve(-3.0, 0.0).risesUpTo(1.0));
  EXPECT_FALSE(curve(-1.0, 0.0, 0.0, 0.0, true).risesUpTo(1.0)) << "infinite at 1";
  EXPECT_FALSE((LensCurve{{0.0, 1.0, 0.0, 0.0, 0.0}, false}.risesUpTo(1.0))) << "flat at the centre";
}

RC_GTEST_PROP(LensCurve, RadiusIsTheInverseOfTangent, ()) {
  const LensCurve c = randomCurve();
  const double end = random::real(0.1, 2.0);
  RC_PRE(c.risesUpTo(end));
  const double r = random::real(0.0, end);
  const auto found = c.radius(c.tangent(r), end);
  RC_ASSERT(found.has_value());
  RC_ASSERT(std::abs(c.tangent(*found) - c.tangent(r)) <= 1e-12 * (1.0 + c.tangent(end)));
  RC_ASSERT(!c.radius(1.001 * c.tangent(end), end).has_value());
  RC_ASSERT(!c.radius(-0.001, end).has_value());
}

Lens someLens() {
  return {random::real(200.0, 800.0), random::real(300.0, 900.0),
          random::real(300.0, 700.0), random::real(0.5, 1.2),
          random::real(0.5, 1.8),     {curve(0.2, 0.1), curve(0.22, 0.12), curve(0.25, 0.13)}};
}

constexpr int kWidth = 1000;
constexpr int kHeight = 1200;

RC_GTEST_PROP(Lens, ShownAndSeenAreInverse, ()) {
  const Lens lens = someLens();
  const PixelPoint p{random::real(0.0, kWidth), random::real(0.0, kHeight)};
  const double r = std::hypot(p.x - lens.centre_x, p.y - lens.centre_y) / lens.unit_px;
  RC_PRE(std::abs(r - lens.radius) > 1e-6);
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const auto back = lens.shown(colour, lens.seen(colour, p));
    RC_ASSERT(back.has_value() == (r < lens.radius));
    if (back) RC_ASSERT(std::hypot(back->x - p.x, back->y - p.y) < 1e-8);
  }
}

RC_GTEST_PROP(Lens, ItsViewHasInItAllThatItShowsAndNoMore, ()) {
  const Lens lens = someLens();
  const FieldOfView view = lens.view(kWidth, kHeight);
  FieldOfView needed{0.0, 0.0, 0.0, 0.0};
  for (int i = 0; i <= 100; ++i)
    for (int j = 0; j <= 100; ++j) {
      const PixelPoint p{i * kWidth / 100.0, j * kHeight / 100.0};
      if (std::hypot(p.x - lens.centre_x, p.y - lens.centre_y) > lens.radius * lens.unit_px) continue;
      for (std::size_t colour = 0; colour < 3; ++colour) {
        const Direction seen = lens.seen(colour, p);
        needed.tan_right = std::max(needed.tan_right, seen.right);
        needed.tan_left = std::max(needed.tan_left, -seen.right);
        needed.tan_up = std::max(needed.tan_up, seen.up);
        needed.tan_down = std::max(needed.tan_down, -seen.up);
      }
    }
  // What the border may have between two of these points.
  const double between =
      2.0 * (kHeight / 100.0) / lens.unit_px * lens.tangent * lens.curves[2].slope(lens.radius);
  for (const auto side :
       {&FieldOfView::tan_left, &FieldOfView::tan_right, &FieldOfView::tan_down, &FieldOfView::tan_up}) {
    RC_ASSERT((view.*side > needed.*side - 1e-6));
    RC_ASSERT((view.*side < needed.*side + between));
  }
}

TEST(Lens, UpIsUpAndRightIsRight) {
  const Lens lens{500.0, 600.0, 500.0, 1.0, 2.0, {curve(0.0, 0.0), curve(0.0, 0.0), curve(0.0, 0.0)}};
  const Direction seen = lens.seen(1, {750.0, 350.0});
  EXPECT_NEAR(seen.right, 0.5, 1e-15);
  EXPECT_NEAR(seen.up, 0.5, 1e-15);
  EXPECT_EQ(lens.pixelsPerTangent(), 500.0);
}

TEST(Lens, ACentreBesideThePanelIsRefused) {
  Lens lens{500.0, 600.0, 500.0, 1.0, 2.0, {}};
  lens.centre_x = -1.0;
  EXPECT_THROW(lens.view(kWidth, kHeight), std::domain_error);
}

RC_GTEST_PROP(ViewOfScreen, PointsOnTheScreenKeepTheirPlaceWhereverTheEyeIs, ()) {
  const double width = random::real(0.1, 3.0);
  const double height = random::real(0.1, 3.0);
  const Coord3 eye{random::real(-3.0, 3.0), random::real(-3.0, 3.0), random::real(0.05, 3.0)};
  const Coord3 on_screen{random::real(-0.5, 0.5) * width, random::real(-0.5, 0.5) * height, 0.0};
  const PixelPoint at = projectToPixels(viewOfScreen(eye, width, height), on_screen - eye, 1000, 800);
  RC_ASSERT(std::abs(at.x - 1000.0 * (on_screen.x / width + 0.5)) < 1e-7);
  RC_ASSERT(std::abs(at.y - 800.0 * (0.5 - on_screen.y / height)) < 1e-7);
}

}  // namespace
}  // namespace coherency
