// Shadows that are baked, all over the surface they fall on, against many rays. Needs no OpenGL.

#include <array>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "render_client/compile/FixedSurface.h"
#include "render_client/compile/ToneCurve.h"
#include "tests/render/Baked.h"

namespace coherency {
namespace {

/// How light on a wall of 2.4 m by 1.6 m, as it is drawn, differs from what many rays say, all over it:
/// shares of a display's range.
struct Difference {
  double mean = 0.0;
  double p99 = 0.0;
};
Difference fromTruth(const VRObject& fitting) {
  Rectangle wall(2.4, 1.6);
  paint(wall, 0.8);
  Baked baked;
  baked.add(wall);
  baked.add(fitting);
  Illumination lights{
      {{{-0.7, 1.6, 1.4}, {1.0, 1.0, 1.0}, 2.0, 8.0}, {{0.6, 1.5, 1.2}, {1.0, 1.0, 1.0}, 2.0, 8.0}},
      {{0.3, 0.3, 0.3}, {0.2, 0.2, 0.2}}};
  baked.bake = bake(baked.mesh, lights, {});
  for (Light& lamp : lights.lamps) lamp.position -= baked.bake.origin;
  const FixedSurface surface(baked.mesh);
  const LightBaker truth(surface.occluders(), lights, 512);
  const auto shown = [](double light) { return encoded(tone(0.8F * static_cast<float>(light))); };
  std::vector<std::pair<double, double>> differences;  // and their areas
  double area = 0.0;
  for (std::size_t i = 0; i < baked.mesh.indices.size(); i += 3) {
    const std::uint32_t* c = &baked.mesh.indices[i];
    if (baked.mesh.vertices[c[0]].object != 0) continue;
    const SurfacePoint corner[3] = {surface.at(c[0]), surface.at(c[1]), surface.at(c[2])};
    const float part = glm::length(
        glm::cross(corner[1].position - corner[0].position, corner[2].position - corner[0].position));
    for (const std::array<float, 3>& s :
         {std::array{0.6F, 0.2F, 0.2F}, {0.2F, 0.6F, 0.2F}, {0.2F, 0.2F, 0.6F}}) {
      SurfacePoint at{glm::vec3(0.0F), corner[0].normal};
      double drawn = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        at.position += s[k] * corner[k].position;
        drawn += s[k] * baked.light(c[k]);
      }
      const SurfaceLight light = truth.light(at);
      if (light.buried) continue;
      differences.emplace_back(std::abs(shown(drawn) - shown(light.light.g)), part);
      area += part;
    }
  }
  std::sort(differences.begin(), differences.end());
  Difference result;
  double below = 0.0;
  for (const auto& [difference, part] : differences) {
    result.mean += difference * part / area;
    if (below < 0.99 * area) result.p99 = difference;
    below += part;
  }
  return result;
}

TEST(Bake, RodsKeepNoLightAwayWhateverHoldsThem) {
  Rectangle wall(2.0, 2.0);
  std::vector<double> bare;
  std::vector<double> railed;
  for (std::vector<double>* light : {&bare, &railed}) {
    Box rail({2.0, 0.05, 0.04});
    rail.setTransform(TransformMatrix::translation({0.0, 0.1, 0.07}) *
                      TransformMatrix::scaling({1.0, 1.2, 1.0}));
    Baked baked;
    baked.add(wall);
    if (light == &railed) baked.add(rail);
    baked.bakeWith(lampOnly({0.3, 0.9, 1.0}, 10.0, 4.0));
    baked.forEach(0, Coord3{0.0, 0.0, 1.0}, [&](const Coord3&, double at) { light->push_back(at); });
  }
  EXPECT_EQ(bare, railed);
}

TEST(Bake, TheShadowOfABoardBeforeAWallIsRightAllOverTheWall) {
  Box rail({2.0, 0.08, 0.04});
  rail.setPosition(0.0, 0.1, 0.07);
  const Difference off = fromTruth(rail);
  EXPECT_LT(off.mean, 0.009);
  EXPECT_LT(off.p99, 0.16);
}

TEST(Bake, TheShadowOfAShelfIsRightAllOverTheWall) {
  Box shelf({2.0, 0.03, 0.25});
  shelf.setPosition(0.0, 0.2, 0.126);
  const Difference off = fromTruth(shelf);
  EXPECT_LT(off.mean, 0.035);
  EXPECT_LT(off.p99, 0.33);  // beneath it, where the wall behind it is taken to be as above and beneath
}

}  // namespace
}  // namespace coherency
