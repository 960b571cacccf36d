// Baked light against closed forms, and meshes that are cut for it. Needs no OpenGL.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "render_client/compile/FixedSurface.h"
#include "render_client/compile/ToneCurve.h"
#include "tests/render/Baked.h"

namespace coherency {
namespace {

TEST(Bake, APlaneUnderALampIsLitByTheCosineOverTheSquareOfTheDistance) {
  Rectangle floor(6.0, 6.0);
  layDown(floor);
  Baked baked;
  baked.add(floor);
  const Coord3 lamp{0.5, 2.0, -0.3};
  baked.bakeWith(lampOnly(lamp, 3.0));
  EXPECT_GT(baked.mesh.vertices.size(), 36U);
  baked.forEach(0, kUp, [&](const Coord3& at, double light) {
    const double expected = fromLamp(lamp, 3.0, at, kUp);
    EXPECT_NEAR(light, expected, kOff * expected + 0.004);  // what is dimmer than that is left out
  });
}

TEST(Bake, LightIsRightBetweenVerticesToo) {
  Rectangle floor(4.0, 4.0);
  layDown(floor);
  Baked baked;
  baked.add(floor);
  const Coord3 lamp{0.2, 1.0, 0.1};
  baked.bakeWith(lampOnly(lamp, 1.0));
  double worst = 0.0;
  const auto& indices = baked.mesh.indices;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const Coord3 middle =
        (baked.position(indices[i]) + baked.position(indices[i + 1]) + baked.position(indices[i + 2])) / 3.0;
    const double between =
        (baked.light(indices[i]) + baked.light(indices[i + 1]) + baked.light(indices[i + 2])) / 3.0;
    const auto shown = [](double light) { return encoded(tone(static_cast<float>(light))); };
    worst = std::max<double>(worst, std::abs(shown(between) - shown(fromLamp(lamp, 1.0, middle, kUp))));
  }
  EXPECT_LT(worst, 0.03);
}

TEST(Bake, LampsFadeToNothingAtTheirReach) {
  Rectangle floor(12.0, 2.0);
  layDown(floor);
  Baked baked;
  baked.add(floor);
  baked.bakeWith(lampOnly({0.0, 1.0, 0.0}, 10.0, 4.0));
  double last = 1e9;
  baked.forEach(0, kUp, [&](const Coord3& at, double light) {
    if (norm(at - Coord3{0.0, 1.0, 0.0}) >= 4.0) {
      EXPECT_EQ(light, 0.0);
    }
    if (norm(at - Coord3{0.0, 1.0, 0.0}) > 3.5) last = std::min(last, light);
  });
  EXPECT_LT(last, 0.01);
}

TEST(Bake, AmbientComesFromAboveAndBelow) {
  Box block({0.5, 0.5, 0.5});
  Baked baked;
  baked.add(block);
  baked.bakeWith(ambientOnly({0.6, 0.6, 0.6}, {0.2, 0.2, 0.2}));
  baked.forEach(0, kUp, [](const Coord3&, double light) { EXPECT_NEAR(light, 0.6, 1e-5); });
  baked.forEach(0, -kUp, [](const Coord3&, double light) { EXPECT_NEAR(light, 0.2, 1e-5); });
  baked.forEach(0, {1.0, 0.0, 0.0}, [](const Coord3&, double light) { EXPECT_NEAR(light, 0.4, 0.06); });
}

TEST(Bake, ACornerKeepsHalfOfTheAmbientAwayAndTheMiddleOfTheFloorNone) {
  Rectangle floor(8.0, 8.0);
  Rectangle wall(8.0, 8.0);
  layDown(floor);
  wall.setPosition(0.0, 4.0, -4.0);
  paint(floor, 0.0);
  paint(wall, 0.0);
  Baked baked;
  baked.add(floor);
  baked.add(wall);
  baked.bakeWith(ambientOnly({1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}), 512);
  int in_corner = 0;
  baked.forEach(0, kUp, [&](const Coord3& at, double light) {
    const double away = at.z + 4.0;
    if (away < 1e-3 && std::abs(at.x) < 2.5) {
      EXPECT_NEAR(light, 0.5, 0.04);
      ++in_corner;
    }
    if (away > 1.3) {
      EXPECT_NEAR(light, 1.0, 1e-5);
    }
    EXPECT_GT(light, 0.45);
  });
  EXPECT_GT(in_corner, 4);
}

TEST(Bake, ABoxOverAPlaneCastsItsUmbraWhereGeometryPutsIt) {
  Rectangle floor(4.0, 4.0);
  layDown(floor);
  Box box({0.8, 0.02, 0.8});
  paint(box, 0.0);
  box.setPosition(0.0, 1.0, 0.0);
  Baked baked;
  baked.add(floor);
  baked.add(box);
  // Of 0.4 m radius, as wide as the box: the umbra reaches to 0.4 m, all of the shadow to about 0.8.
  const Coord3 lamp{0.0, 3.0, 0.0};
  baked.bakeWith(lampOnly(lamp, 4.0));
  int dark = 0;
  baked.forEach(0, kUp, [&](const Coord3& at, double light) {
    const double aside = std::max(std::abs(at.x), std::abs(at.z));
    const double expected = fromLamp(lamp, 4.0, at, kUp);
    if (aside < 0.38) {
      EXPECT_EQ(light, 0.0) << at.x << ", " << at.z;
      ++dark;
    }
    if (aside > 0.84) {
      EXPECT_NEAR(light, expected, kOff * expected) << at.x << ", " << at.z;
    }
    EXPECT_LE(light, (1.0 + kOff) * expected);
  });
  EXPECT_GT(dark, 8) << "the mesh is fine where the shadow is";
}

/// A room of single faces that look inwards.
struct Room {
  Room() {
    for (int i = 0; i < 6; ++i) {
      walls.push_back(std::make_unique<Rectangle>(2.0, 2.0));
      const double turns = i;
      walls.back()->setTransform((i < 4 ? TransformMatrix::rotationY(turns * kQuarter)
                                        : TransformMatrix::rotationX((2.0 * turns - 9.0) * kQuarter)) *
                                 TransformMatrix::translation({0.0, 0.0, -1.0}));
    }
  }
  std::vector<std::unique_ptr<Rectangle>> walls;
};

TEST(Bake, ALampInAClosedRoomLightsNothingOutside) {
  const Room room;
  Rectangle outside(6.0, 6.0);
  layDown(outside, -1.5);
  Box beside({0.5, 0.5, 0.5});
  beside.setPosition(1.6, 0.0, 0.0);
  for (const bool lamp_inside : {true, false}) {
    Baked baked;
    for (const auto& wall : room.walls) baked.add(*wall);
    baked.add(outside);
    baked.add(beside);
    baked.bakeWith(lampOnly(lamp_inside ? Coord3{0.3, 0.2, 0.1} : Coord3{0.3, 3.0, 0.1}, 4.0));
    for (std::size_t v = 0; v < baked.mesh.vertices.size(); ++v) {
      const bool of_room = baked.mesh.vertices[v].object < 6;
      if (of_room != lamp_inside) {
        EXPECT_EQ(baked.light(v), 0.0) << "lamp inside: " << lamp_inside;
      }
      if (of_room && lamp_inside) {
        EXPECT_GT(baked.light(v), 0.1);
      }
    }
  }
}

TEST(Bake, WhatShinesDoesNotStandInItsOwnLight) {
  Rectangle floor(2.0, 2.0);
  layDown(floor);
  Box fitting({0.4, 0.4, 0.4});
  paint(fitting, 1.0, 1.0);
  const Coord3 lamp{0.0, 1.5, 0.0};
  fitting.setPosition(lamp);
  Baked baked;
  baked.add(floor);
  baked.add(fitting);
  baked.bakeWith(lampOnly(lamp, 2.0));
  baked.forEach(0, kUp, [&](const Coord3& at, double light) {
    const double expected = fromLamp(lamp, 2.0, at, kUp);
    EXPECT_NEAR(light, expected, kOff * expected);
  });
}

TEST(Bake, ColouredWallsTintWhatIsBesideThem) {
  Rectangle floor(4.0, 4.0);
  layDown(floor);
  Rectangle wall(4.0, 4.0);
  wall.setPosition(0.0, 2.0, -2.0);
  wall.setMaterial({{0.9, 0.0, 0.0}, 0.0, 0.0});
  Baked baked;
  baked.add(floor);
  baked.add(wall);
  baked.bakeWith(lampOnly({0.0, 2.0, 0.0}, 4.0));
  for (std::size_t v = 0; v < baked.mesh.vertices.size(); ++v) {
    if (baked.mesh.vertices[v].object != 0) continue;
    const glm::vec3 light = baked.bake.light[v].light;
    if (baked.position(v).z < -1.9 && std::abs(baked.position(v).x) < 1.0) {
      EXPECT_GT(light.r, 1.1F * light.g);
    }
    if (baked.position(v).z > 0.0) {
      EXPECT_FLOAT_EQ(light.r, light.g);
    }
  }
}

TEST(Bake, AFloorIsNoDarkerAboutWhatStandsOnItThanBesideIt) {
  Rectangle floor(4.0, 4.0);
  layDown(floor);
  Box cabinet({1.0, 1.0, 1.0});
  cabinet.setPosition(0.0, 0.5, 0.0);
  Baked baked;
  baked.add(floor);
  baked.add(cabinet);
  baked.bakeWith(ambientOnly({1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}));
  baked.forEach(0, kUp, [](const Coord3& at, double light) {
    const double aside = std::max(std::abs(at.x), std::abs(at.z));
    if (aside > 0.35) {
      EXPECT_GT(light, 0.4) << "at " << at.x << ", " << at.z << ": no dark seam shows beside it";
    }
  });
}

TEST(Bake, AStripBetweenTwoThingsThatHoldItsEndsIsLit) {
  // All four corners of the wall are in the inside of something, its middle is not.
  Rectangle wall(0.15, 0.9);
  Box above({0.3, 0.1, 0.1}), below({0.3, 0.1, 0.1});
  above.setPosition(0.0, 0.45, 0.0);
  below.setPosition(0.0, -0.45, 0.0);
  Baked baked;
  baked.add(wall);
  baked.add(above);
  baked.add(below);
  baked.bakeWith(ambientOnly({0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}));
  double brightest = 0.0, darkest = 1.0;
  baked.forEach(0, {0.0, 0.0, 1.0}, [&](const Coord3& at, double light) {
    if (std::abs(at.y) < 0.2) brightest = std::max(brightest, light);
    darkest = std::min(darkest, light);
  });
  EXPECT_GT(brightest, 0.4);
  EXPECT_GT(darkest, 0.05) << "and what is held takes its neighbours' light";
}

TEST(Bake, SomethingThatMovesTakesAwayNoMoreThanComesFromAbove) {
  Rectangle floor(3.0, 3.0);
  layDown(floor);
  Rectangle table(1.0, 1.0);
  layDown(table, 0.7);
  Baked baked;
  baked.add(floor);
  baked.add(table);
  Illumination light = lampOnly({0.0, 2.5, 0.0}, 4.0);
  light.ambient = {{0.4, 0.4, 0.4}, {0.2, 0.2, 0.2}};
  baked.bakeWith(light);
  for (std::size_t v = 0; v < baked.mesh.vertices.size(); ++v) {
    const Coord3 at = baked.position(v);
    const SurfaceLight& surface = baked.bake.light[v];
    EXPECT_LE(surface.shade, 1.0F);
    if (baked.mesh.vertices[v].object == 1) {
      EXPECT_GT(surface.shade, 0.4F);
    }
    if (baked.mesh.vertices[v].object == 0 && std::max(std::abs(at.x), std::abs(at.z)) < 0.1) {
      EXPECT_EQ(surface.shade, 0.0F) << "under the table";
    }
  }
}

/// A plane 4 m wide and deep, made in different ways.
TEST(Bake, ScaledAndMirroredShapesAreLitAsIfTheyHadBeenMadeSo) {
  const Coord3 lamp{0.4, 1.5, 0.2};
  const auto brightest = [&](const Coord3& size, const Coord3& scale) {
    Box slab(size);
    slab.scale(scale);
    Baked baked;
    baked.add(slab);
    baked.bakeWith(lampOnly(lamp, 2.0));
    double worst = 0.0;
    int seen = 0;
    baked.forEach(0, kUp, [&](const Coord3& at, double light) {
      worst = std::max(worst, std::abs(light - fromLamp(lamp, 2.0, at, kUp)));
      ++seen;
    });
    EXPECT_GT(seen, 20);
    return worst;
  };
  EXPECT_LT(brightest({4.0, 0.2, 4.0}, {1.0, 1.0, 1.0}), 0.02);
  EXPECT_LT(brightest({1.0, 1.0, 8.0}, {4.0, 0.2, 0.5}), 0.02);
  EXPECT_LT(brightest({4.0, 0.2, 4.0}, {-1.0, 1.0, 1.0}), 0.02);
  EXPECT_LT(brightest({2.0, 0.1, 4.0}, {-2.0, -2.0, -1.0}), 0.02);
}

TEST(Bake, ShearedShapesHaveTheirNormalsAcrossTheirFaces) {
  Box box({1.0, 1.0, 1.0});
  TransformMatrix shear;
  shear(0, 1) = 0.8;
  shear(2, 1) = -0.3;
  Baked baked;
  baked.mesh.add(box, shear);
  baked.bakeWith(lampOnly({0.0, 3.0, 0.0}, 4.0));
  const auto& indices = baked.mesh.indices;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const Coord3 a = baked.position(indices[i]);
    const Coord3 across =
        normalized(cross(baked.position(indices[i + 1]) - a, baked.position(indices[i + 2]) - a));
    EXPECT_GT(dot(across, baked.normal(indices[i])), 0.9999);
  }
}

/// Position as it is told from others when edges are counted.
using Place = std::array<std::int64_t, 3>;
Place place(const Coord3& at) {
  constexpr double kFine = 1e5;
  return {std::llround(kFine * at.x), std::llround(kFine * at.y), std::llround(kFine * at.z)};
}

/// Every edge belongs to two triangles that run along it in opposite directions.
void expectClosed(const Baked& baked) {
  std::map<std::pair<Place, Place>, int> edges;
  const auto& indices = baked.mesh.indices;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    ++edges[{place(baked.position(indices[i])), place(baked.position(indices[next]))}];
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
}

TEST(Bake, CuttingOpensNoGapAcrossCreasesEither) {
  const Coord3 lamp{0.6, 0.9, 0.5};
  Box box({3.0, 0.2, 1.1});
  Cylinder cylinder(0.5, 1.0, 16);
  Ellipsoid ball({0.5, 0.5, 0.5}, 16);
  box.setOrientation(TransformMatrix::rotationY(0.4));
  cylinder.scale({-1.0, 1.5, 1.0});
  for (const VRObject* object : std::initializer_list<const VRObject*>{&box, &cylinder, &ball}) {
    Baked baked;
    baked.add(*object);
    const std::size_t before = baked.mesh.indices.size();
    baked.bakeWith(lampOnly(lamp, 1.0), 16);
    EXPECT_GT(baked.mesh.indices.size(), before);
    expectClosed(baked);
  }
}

TEST(Bake, WithoutRaysThingsAreLitAsIfEachStoodAloneAndAreNotCut) {
  Rectangle floor(6.0, 6.0);
  layDown(floor);
  Box above({2.0, 0.1, 2.0});
  above.setPosition(0.0, 1.0, 0.0);
  Baked baked;
  baked.add(floor);
  baked.add(above);
  const std::vector<std::uint32_t> before = baked.mesh.indices;
  const Coord3 lamp{0.2, 3.0, -0.1};
  Illumination illumination = lampOnly(lamp, 3.0);
  illumination.ambient = {{0.3, 0.3, 0.3}, {0.1, 0.1, 0.1}};
  baked.bakeWith(illumination, 0);
  EXPECT_EQ(baked.mesh.indices, before);
  ASSERT_EQ(baked.bake.light.size(), baked.mesh.vertices.size());
  for (const std::uint32_t object : {0U, 1U})
    baked.forEach(object, kUp, [&](const Coord3& at, double light) {
      EXPECT_NEAR(light, 0.3 + fromLamp(lamp, 3.0, at, kUp), 0.01);
    });
  baked.forEach(1, -kUp, [](const Coord3&, double light) { EXPECT_NEAR(light, 0.1, 1e-5); });
}

TEST(ToneCurve, TheShadersEncodeAsSrgbToATenthOfAPercentInTheDarkToo) {
  for (int i = 0; i <= 100000; ++i) {
    const float linear = static_cast<float>(i) * 1e-5F;
    ASSERT_NEAR(encodedByShaders(linear), encoded(linear), 0.0009F) << linear;
  }
}

TEST(Bake, GivesTheSameBitsEveryTime) {
  Rectangle floor(4.0, 4.0);
  layDown(floor);
  Cylinder post(0.1, 1.0, 12);
  post.setPosition(0.3, 0.5, 0.2);
  const auto once = [&] {
    Baked baked;
    baked.add(floor);
    baked.add(post);
    Illumination light = lampOnly({1.0, 2.0, 0.0}, 2.0);
    light.ambient = {{0.4, 0.4, 0.4}, {0.2, 0.2, 0.2}};
    baked.bakeWith(light, 16);
    return baked;
  };
  const Baked first = once();
  for (int again = 0; again < 3; ++again) {
    const Baked other = once();
    ASSERT_EQ(other.mesh.indices, first.mesh.indices);
    for (std::size_t v = 0; v < first.mesh.vertices.size(); ++v) {
      ASSERT_EQ(other.mesh.vertices[v].position, first.mesh.vertices[v].position);
      ASSERT_EQ(other.bake.light[v].light, first.bake.light[v].light);
      ASSERT_EQ(other.bake.light[v].shade, first.bake.light[v].shade);
    }
  }
}

}  // namespace
}  // namespace coherency
