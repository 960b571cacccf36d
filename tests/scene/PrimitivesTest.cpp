#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/scene/Primitives.h"
#include "tests/scene/Shapes.h"
#include "tests/scene/Support.h"

namespace coherency {
namespace {

using Refused = std::invalid_argument;
constexpr double kPi = 3.141592653589793;
constexpr double kBadSizes[] = {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity()};

std::size_t facesWithCorners(const FaceSet& set, std::size_t corners) {
  return static_cast<std::size_t>(std::count_if(set.faces.begin(), set.faces.end(),
                                                [&](const auto& face) { return face.size() == corners; }));
}

RC_GTEST_PROP(Box, IsAClosedCuboid, ()) {
  const Coord3 size{anyLength(), anyLength(), anyLength()};
  const Box box(size);
  const FaceSet& set = *box.faces();
  RC_ASSERT(box.polygonCount() == 6u);
  RC_ASSERT(facesWithCorners(set, 4) == 6u);
  RC_ASSERT(isClosed(set));
  RC_ASSERT(facesOutward(set));
  RC_ASSERT(!set.smooth);
  const double exact = size.x * size.y * size.z;
  RC_ASSERT(std::abs(volume(set) - exact) < 1e-12 * exact);
  for (const Coord3& v : set.vertices)
    RC_ASSERT(Coord3(std::abs(v.x), std::abs(v.y), std::abs(v.z)) == 0.5 * size);
}

RC_GTEST_PROP(Cylinder, IsAClosedPrism, ()) {
  const double radius = anyLength();
  const double height = anyLength();
  const int n = anySides();
  const Cylinder cylinder(radius, height, n);
  const FaceSet& set = *cylinder.faces();
  RC_ASSERT(cylinder.polygonCount() == static_cast<std::size_t>(n) + 2u);
  RC_ASSERT(isClosed(set));
  RC_ASSERT(facesOutward(set));
  const double exact = 0.5 * n * radius * radius * std::sin(2.0 * kPi / n) * height;
  RC_ASSERT(std::abs(volume(set) - exact) < 1e-9 * exact);
  for (const Coord3& v : set.vertices) {
    RC_ASSERT(std::abs(v.y) == 0.5 * height);
    RC_ASSERT(std::abs(std::hypot(v.x, v.z) - radius) < 1e-12 * radius);
  }
}

RC_GTEST_PROP(Cylinder, TaperedIsAClosedFrustumOrCone, ()) {
  const double bottom = *rc::gen::arbitrary<bool>() ? anyLength() : 0.0;
  const double top = bottom == 0.0 || *rc::gen::arbitrary<bool>() ? anyLength() : 0.0;
  const double height = anyLength();
  const int n = anySides();
  const auto sides = static_cast<std::size_t>(n);
  Cylinder cone;
  cone.setTapered(bottom, top, height, n);
  const FaceSet& set = *cone.faces();
  RC_ASSERT(isClosed(set));
  const bool pointed = bottom == 0.0 || top == 0.0;
  RC_ASSERT(set.faces.size() == sides + (pointed ? 1u : 2u));
  RC_ASSERT(set.vertices.size() == (pointed ? sides + 1u : 2u * sides));
  if (n > 4) RC_ASSERT(facesWithCorners(set, pointed ? 3 : 4) == sides);
  const double base = 0.5 * n * std::sin(2.0 * kPi / n);
  const double exact = base * height / 3.0 * (bottom * bottom + bottom * top + top * top);
  RC_ASSERT(std::abs(volume(set) - exact) < 1e-9 * exact);
}

/// Angle between the normals of two faces.
double angleBetween(const FaceSet& set, std::size_t a, std::size_t b) {
  const Coord3 na = areaVector(set, set.faces[a]);
  const Coord3 nb = areaVector(set, set.faces[b]);
  return std::atan2(norm(cross(na, nb)), dot(na, nb));
}

TEST(Cylinder, IsSmoothAroundAndSharpAtItsCaps) {
  for (const int sides : {6, 8, 24, 200})
    for (const double top : {0.5, 0.4, 0.05, 0.0}) {
      Cylinder cylinder;
      cylinder.setTapered(0.5, top, 1.0, sides);
      const FaceSet& set = *cylinder.faces();
      EXPECT_TRUE(set.smooth);
      EXPECT_LT(angleBetween(set, 0, 1), set.crease_angle) << sides << ' ' << top;
      for (std::size_t cap = static_cast<std::size_t>(sides); cap < set.faces.size(); ++cap)
        EXPECT_GT(angleBetween(set, 0, cap), set.crease_angle) << sides << ' ' << top;
    }
}

TEST(Cylinder, WithFewSidesIsSharpAllOver) {
  for (const int sides : {3, 4}) {
    const Cylinder prism(0.5, 1.0, sides);
    EXPECT_GT(angleBetween(*prism.faces(), 0, 1), prism.faces()->crease_angle);
  }
}

RC_GTEST_PROP(Ellipsoid, IsAClosedSurfaceOnTheEllipsoid, ()) {
  const Coord3 axes{anyLength(), anyLength(), anyLength()};
  const int n = 2 * *rc::gen::inRange(2, 25);
  const auto sides = static_cast<std::size_t>(n);
  const Ellipsoid ellipsoid(axes, n);
  const FaceSet& set = *ellipsoid.faces();
  RC_ASSERT(ellipsoid.polygonCount() == sides * (sides / 2));
  RC_ASSERT(facesWithCorners(set, 3) == 2 * sides);
  RC_ASSERT(isClosed(set));
  RC_ASSERT(facesOutward(set));
  RC_ASSERT(set.smooth);
  for (const Coord3& v : set.vertices)
    RC_ASSERT(std::abs(norm({v.x / axes.x, v.y / axes.y, v.z / axes.z}) - 1.0) < 1e-12);
}

TEST(Ellipsoid, FillsTheVolumeOfTheEllipsoidAsSidesGrow) {
  const Coord3 axes{0.5, 1.0, 2.0};
  const double exact = 4.0 / 3.0 * kPi * axes.x * axes.y * axes.z;
  double last_error = 1.0;
  for (const int sides : {8, 16, 32, 64}) {
    const double error = 1.0 - volume(*Ellipsoid(axes, sides).faces()) / exact;
    EXPECT_GT(error, 0.0);
    EXPECT_LT(error, 0.3 * last_error);
    last_error = error;
  }
}

TEST(Rectangle, IsSeenFromPlusZ) {
  const Rectangle rectangle(3.0, 2.0);
  const FaceSet& set = *rectangle.faces();
  EXPECT_EQ(rectangle.polygonCount(), 1u);
  expectNear(areaVector(set, set.faces[0]), {0.0, 0.0, 12.0});
  for (const Coord3& v : set.vertices)
    EXPECT_EQ(Coord3(std::abs(v.x), std::abs(v.y), v.z), Coord3(1.5, 1.0, 0.0));
}

TEST(Primitives, TakeANewSizeAndKeepTheirName) {
  Box box({1.0, 1.0, 1.0}, "crate");
  box.setSize({2.0, 3.0, 4.0});
  EXPECT_NEAR(volume(*box.faces()), 24.0, 1e-12);
  EXPECT_EQ(box.name(), "crate");
  Cylinder cylinder;
  cylinder.setSize(1.0, 2.0, 6);
  EXPECT_EQ(cylinder.polygonCount(), 8u);
  Ellipsoid ellipsoid;
  ellipsoid.setSize({1.0, 1.0, 1.0}, 4);
  EXPECT_EQ(ellipsoid.polygonCount(), 8u);
  Rectangle rectangle;
  rectangle.setSize(5.0, 6.0);
  EXPECT_EQ(areaVector(*rectangle.faces(), rectangle.faces()->faces[0]).z, 60.0);
}

TEST(Primitives, RefuseBadSizesAndNameThem) {
  for (const double bad : kBadSizes) {
    expectRefusal<Refused>([&] { Box({bad, 1.0, 1.0}); }, "Box", "size x");
    expectRefusal<Refused>([&] { Box({1.0, bad, 1.0}); }, "Box", "size y");
    expectRefusal<Refused>([&] { Box({1.0, 1.0, bad}); }, "Box", "size z");
    expectRefusal<Refused>([&] { Cylinder(bad, 1.0); }, "Cylinder", "radius");
    expectRefusal<Refused>([&] { Cylinder(1.0, bad); }, "Cylinder", "height");
    expectRefusal<Refused>([&] { Ellipsoid({1.0, bad, 1.0}); }, "Ellipsoid", "semi-axis y");
    expectRefusal<Refused>([&] { Rectangle(bad, 1.0); }, "Rectangle", "width");
    expectRefusal<Refused>([&] { Rectangle(1.0, bad); }, "Rectangle", "height");
  }
  Cylinder cylinder;
  expectRefusal<Refused>([&] { cylinder.setTapered(-0.1, 1.0, 1.0); }, "bottom radius", "-0.1");
  expectRefusal<Refused>([&] { cylinder.setTapered(0.1, -1.0, 1.0); }, "top radius");
  expectRefusal<Refused>([&] { cylinder.setTapered(0.0, 0.0, 1.0); }, "radius", "above zero");
}

TEST(Primitives, RefuseBadNumbersOfSides) {
  for (const int bad : {-5, 0, 2, 1025})
    expectRefusal<Refused>([&] { Cylinder(1.0, 1.0, bad); }, "sides", "3 to 1024");
  for (const int bad : {-4, 0, 2, 1026})
    expectRefusal<Refused>([&] { Ellipsoid({1, 1, 1}, bad); }, "sides", "4 to 1024");
  expectRefusal<Refused>([] { Ellipsoid({1, 1, 1}, 7); }, "7 sides", "even");
  EXPECT_NO_THROW(Cylinder(1.0, 1.0, 1024));
}

}  // namespace
}  // namespace coherency
