#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "common/scene/Polygon.h"
#include "common/scene/Polyhedron.h"
#include "tests/scene/Support.h"

namespace coherency {
namespace {

using Refused = std::invalid_argument;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<Coord3> square(double size, const Coord3& at = {}) {
  return {at, at + Coord3{size, 0, 0}, at + Coord3{size, size, 0}, at + Coord3{0, size, 0}};
}

TEST(Polygon, HoldsItsVerticesAsOneFace) {
  const Polygon polygon(square(2.0), "sheet");
  EXPECT_EQ(polygon.name(), "sheet");
  EXPECT_EQ(polygon.faces()->vertices, square(2.0));
  EXPECT_EQ(polygon.faces()->faces, (std::vector<std::vector<std::uint32_t>>{{0, 1, 2, 3}}));
  EXPECT_EQ(polygon.polygonCount(), 1u);
  EXPECT_EQ(Polygon().polygonCount(), 0u);
}

TEST(Polygon, IsTakenAtEverySizeAndFarFromItsOrigin) {
  for (const double size : {1e-200, 1e-9, 1.0, 1e9, 1e200}) EXPECT_NO_THROW(Polygon(square(size))) << size;
  EXPECT_NO_THROW(Polygon(square(0.01, {1e6, 1e6, 1e6})));
  EXPECT_NO_THROW(Polygon({{0, 0, 0}, {100, 0, 0}, {100, 1e-4, 0}, {0, 1e-4, 0}}));  // slender
  EXPECT_NO_THROW(Polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}}));            // a vertex on an edge
}

TEST(Polygon, RefusesTooFewOrUnusableVertices) {
  expectRefusal<Refused>([] { Polygon({{0, 0, 0}, {1, 0, 0}}, "flag"); }, "flag", "2 vertices", "at least 3");
  expectRefusal<Refused>([] { Polygon(std::vector<Coord3>{}); }, "0 vertices");
  expectRefusal<Refused>([] { Polygon({{0, 0, 0}, {1, 0, 0}, {0, kNan, 0}}); }, "vertex 2", "not finite");
  expectRefusal<Refused>([] { Polygon({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}); }, "1 and 2 coincide");
  expectRefusal<Refused>([] { Polygon({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}); }, "coincide");
  expectRefusal<Refused>([] { Polygon({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}); }, "no area");
}

TEST(Polygon, RefusesWhatIsNotPlane) {
  auto bent = square(10.0);
  bent[2].z = 4e-6;  // within 1e-6 of the extent of about 7
  EXPECT_NO_THROW(Polygon{bent});
  bent[2].z = 1e-3;
  expectRefusal<Refused>([&] { Polygon{bent}; }, "out of the plane");
}

TEST(Polygon, RefusesWhatIsNotConvex) {
  expectRefusal<Refused>([] { Polygon({{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}); }, "not convex");
  std::vector<Coord3> star;  // every turn is to the left, but it goes round twice
  for (int i = 0; i < 5; ++i)
    star.push_back({std::cos(i * 2.513274122871834), std::sin(i * 2.513274122871834), 0.0});
  expectRefusal<Refused>([&] { Polygon{star}; }, "not convex");
  expectRefusal<Refused>(
      [] {
        Polygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1.5, 0}});
      },
      "not convex");  // bow tie
}

TEST(Polygon, ARefusedShapeLeavesTheOldOne) {
  Polygon polygon(square(1.0));
  EXPECT_THROW(polygon.setShape({{0, 0, 0}}), Refused);
  EXPECT_EQ(polygon.faces()->vertices, square(1.0));
}

TEST(Polygon, ShapesKeepTheirMaterial) {
  Polygon polygon;
  polygon.setMaterial({{0.1, 0.2, 0.3}, 0.4, 0.5});
  polygon.setShape(square(1.0));
  EXPECT_EQ(polygon.faces()->material.gloss, 0.4);
  polygon.setColour(0.9, 0.8, 0.7);
  EXPECT_EQ(polygon.faces()->material.colour, Coord3(0.9, 0.8, 0.7));
  EXPECT_EQ(polygon.faces()->material.emission, 0.5);
}

const std::vector<Coord3> kTetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

TEST(Polyhedron, HoldsWhatItIsGiven) {
  Polyhedron solid(kTetrahedron, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, "tetrahedron");
  EXPECT_EQ(solid.polygonCount(), 4u);
  EXPECT_FALSE(solid.faces()->smooth);
  solid.setShape(kTetrahedron, {{0, 2, 1}}, true);
  EXPECT_EQ(solid.polygonCount(), 1u);
  EXPECT_TRUE(solid.faces()->smooth);
}

TEST(Polyhedron, RefusesBadFacesAndNamesThem) {
  Polyhedron solid("rock");
  expectRefusal<Refused>(
      [&] {
        solid.setShape(kTetrahedron, {{0, 2, 1}, {0, 1, 4}});
      },
      "rock", "face 1", "index 4", "4 vertices");
  expectRefusal<Refused>([&] { solid.setShape(kTetrahedron, {{0, 1}}); }, "face 0", "at least 3");
  expectRefusal<Refused>([&] { solid.setShape(kTetrahedron, {{0, 1, 1}}); }, "face 0", "coincide");
  expectRefusal<Refused>([&] { solid.setShape(kTetrahedron, {{0, 1, 2, 3}}); }, "face 0", "plane");
  auto bad = kTetrahedron;
  bad[3].y = kNan;
  expectRefusal<Refused>([&] { solid.setShape(bad, {{0, 2, 1}}); }, "rock", "vertex 3", "not finite");
  EXPECT_EQ(solid.polygonCount(), 0u);
}

TEST(Polyhedron, RefusesAnImpossibleCreaseAngle) {
  Polyhedron solid;
  solid.setCreaseAngle(1.25);
  EXPECT_EQ(solid.faces()->crease_angle, 1.25);
  EXPECT_THROW(solid.setCreaseAngle(-0.1), Refused);
  EXPECT_THROW(solid.setCreaseAngle(kNan), Refused);
}

}  // namespace
}  // namespace coherency
