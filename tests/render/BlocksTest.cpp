// How fixed objects are put into blocks, and large flat faces' light into a texture. Needs no OpenGL.

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "render_client/compile/FixedBlocks.h"
#include "render_client/compile/Grouping.h"
#include "render_client/compile/ToneCurve.h"
#include "tests/render/Baked.h"

namespace coherency {
namespace {

double longest(const glm::dvec3& extent) {
  return std::max({extent.x, extent.y, extent.z});
}

TEST(Grouping, PutsEveryItemInOneGroupWithinItsLimits) {
  std::mt19937 engine(4);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  const auto anywhere = [&](double reach) {
    return glm::dvec3(between(-reach, reach), between(-reach, reach), between(-reach, reach));
  };
  for (int round = 0; round < 50; ++round) {
    std::vector<GroupItem> items(static_cast<std::size_t>(between(0.0, 400.0)));
    for (GroupItem& item : items) {
      const glm::dvec3 at = anywhere(30.0);
      const glm::dvec3 half = glm::abs(anywhere(between(0.1, 5.0)));
      item = {at - half, at + half, static_cast<std::uint32_t>(between(1.0, 60.0))};
    }
    std::set<std::uint32_t> seen;
    for (const std::vector<std::uint32_t>& members : group(items, 100, 6.0)) {
      ASSERT_FALSE(members.empty());
      glm::dvec3 low = items[members[0]].low;
      glm::dvec3 high = items[members[0]].high;
      std::size_t triangles = 0;
      for (const std::uint32_t i : members) {
        EXPECT_TRUE(seen.insert(i).second) << "in two groups";
        low = glm::min(low, items[i].low);
        high = glm::max(high, items[i].high);
        triangles += items[i].triangles;
      }
      if (members.size() == 1) continue;
      EXPECT_LE(triangles, 100U);
      EXPECT_LE(longest(high - low), 6.0);
    }
    EXPECT_EQ(seen.size(), items.size());
  }
}

TEST(Grouping, ThingsInOnePlaceComeToAnEnd) {
  const std::vector<GroupItem> items(1000, {glm::dvec3(1.0), glm::dvec3(2.0), 7});
  EXPECT_GE(group(items, 50, 4.0).size(), 1000U * 7 / 50);
}

/// A floor under a lamp, and a table on it whose shadow has to be cut into the floor.
struct Lit {
  Lit() {
    layDown(floor);
    table.setPosition(0.3, 0.7, -0.2);
    turned.setTransform(TransformMatrix::translation({-1.4, 0.3, 0.9}) * TransformMatrix::rotationY(0.6));
    ball.setPosition(1.5, 0.4, 1.2);
    for (const VRObject* object : {static_cast<VRObject*>(&floor), static_cast<VRObject*>(&table),
                                   static_cast<VRObject*>(&turned), static_cast<VRObject*>(&ball)})
      baked.add(*object);
    uncut = baked.mesh.indices;
    baked.bakeWith(lampOnly({0.0, 2.5, 0.0}, 3.0), 64);
  }

  Rectangle floor{4.0, 3.0};
  Box table{{1.2, 0.05, 0.8}};
  Box turned{{0.9, 0.6, 0.7}};
  Ellipsoid ball{{0.4, 0.4, 0.4}, 16};
  Baked baked;
  std::vector<std::uint32_t> uncut;
};

glm::dvec4 texelAt(const Lightmap& map, const glm::vec2& place) {
  const glm::dvec2 at = glm::dvec2(place) * glm::dvec2(map.width(), map.height()) - 0.5;
  const glm::dvec2 cell = glm::floor(at);
  const glm::dvec2 f = at - cell;
  const auto texel = [&](double x, double y) {
    const auto number =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width()) + static_cast<std::size_t>(x);
    const auto& s = map.texels()[number].share;
    return glm::dvec4(s[0], s[1], s[2], s[3]) / 65535.0;
  };
  return glm::mix(glm::mix(texel(cell.x, cell.y), texel(cell.x + 1, cell.y), f.x),
                  glm::mix(texel(cell.x, cell.y + 1), texel(cell.x + 1, cell.y + 1), f.x), f.y);
}

TEST(Lightmap, HasTheLightThatTheCutSurfaceHas) {
  Lit lit;
  const FixedMesh& mesh = lit.baked.mesh;
  const Lightmap map(mesh, lit.uncut, lit.baked.bake.light, 0.04);
  ASSERT_GT(map.width(), 0);
  std::vector<double> off;
  double area = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    if (!map.has(mesh.indices[i])) continue;
    glm::vec2 place(0.0F);
    double light = 0.0;
    for (std::size_t c = i; c < i + 3; ++c) {
      place += map.place(mesh, mesh.indices[c]) / 3.0F;
      light += lit.baked.light(mesh.indices[c]) / 3.0;
    }
    const double there = PackedLight::kBrightest * texelAt(map, place).y;
    off.push_back(
        std::abs(encoded(tone(static_cast<float>(there))) - encoded(tone(static_cast<float>(light)))));
    const auto at = [&](std::size_t c) { return glm::dvec3(mesh.vertices[mesh.indices[i + c]].position); };
    const double of_this = 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
    area += of_this;
    sum += of_this * off.back();
  }
  std::sort(off.begin(), off.end());
  EXPECT_GT(off.size(), 100U);
  EXPECT_LT(sum / area, 0.002) << "in the mean over the surface, of white";
  EXPECT_LT(off[off.size() * 9 / 10], 0.03) << "most triangles are at a shadow's edge, as wide as a texel";
}

TEST(Lightmap, SurfacesDoNotShareTexels) {
  Lit lit;
  const Lightmap map(lit.baked.mesh, lit.uncut, lit.baked.bake.light, 0.04);
  // Rectangles about the surfaces, with the row of texels around each, must not touch.
  struct Rectangle4 {
    glm::dvec2 low{1e9}, high{-1e9};
  };
  const Charts charts = findCharts(lit.baked.mesh, lit.uncut);
  std::vector<Rectangle4> all(charts.charts.size());
  for (std::uint32_t v = 0; v < lit.baked.mesh.vertices.size(); ++v) {
    if (!map.has(v)) continue;
    Rectangle4& mine = all[charts.of_vertex[v]];
    const glm::dvec2 at = glm::dvec2(map.place(lit.baked.mesh, v)) * glm::dvec2(map.width(), map.height());
    mine.low = glm::min(mine.low, at);
    mine.high = glm::max(mine.high, at);
  }
  for (std::size_t a = 0; a < all.size(); ++a) {
    EXPECT_GE(std::min(all[a].low.x, all[a].low.y), 1.49) << "a row of texels beside it";
    EXPECT_LE(all[a].high.x, map.width() - 1.49);
    EXPECT_LE(all[a].high.y, map.height() - 1.49);
    for (std::size_t b = 0; b < a; ++b) {
      const bool beside = all[a].low.x - all[b].high.x > 2.98 || all[b].low.x - all[a].high.x > 2.98 ||
                          all[a].low.y - all[b].high.y > 2.98 || all[b].low.y - all[a].high.y > 2.98;
      EXPECT_TRUE(beside) << a << " and " << b;
    }
  }
}

/// Areas of an object's faces in blocks, seen against where they stand.
template <class Vertex>
double areaOf(const BlockSurfaces<Vertex>& surfaces, const VRObject& object) {
  double area = 0.0;
  for (const BlockPart& part : surfaces.parts) {
    if (part.object != &object) continue;
    const Block& block = surfaces.blocks[part.block];
    const auto at = [&](std::uint32_t i) {
      const float* p = surfaces.vertices[block.range.first_vertex + surfaces.indices[i]].position;
      EXPECT_LE(std::abs(p[0]), block.half_extent.x);
      EXPECT_LE(std::abs(p[1]), block.half_extent.y);
      EXPECT_LE(std::abs(p[2]), block.half_extent.z);
      return glm::dvec3(p[0], p[1], p[2]);
    };
    for (std::uint32_t i = part.range.first_index; i < part.range.first_index + part.range.index_count;
         i += 3)
      area += 0.5 * glm::length(glm::cross(at(i + 1) - at(i), at(i + 2) - at(i)));
  }
  return area;
}

TEST(FixedBlocks, ShowEveryFaceOnceAndFlatOnesUncut) {
  Lit lit;
  const std::size_t cut = lit.baked.mesh.indices.size();
  const FixedBlocks blocks(lit.baked.mesh, lit.uncut, lit.baked.bake.light, 0.04);
  EXPECT_EQ(blocks.object_count, 4U);
  const auto area = [&](const VRObject& object) {
    return areaOf(blocks.lit, object) + areaOf(blocks.mapped, object);
  };
  EXPECT_NEAR(area(lit.floor), 12.0, 1e-4);
  EXPECT_NEAR(area(lit.table), 2.0 * (1.2 * 0.05 + 1.2 * 0.8 + 0.05 * 0.8), 1e-4);
  EXPECT_NEAR(area(lit.turned), 2.0 * (0.9 * 0.6 + 0.9 * 0.7 + 0.6 * 0.7), 1e-4);
  EXPECT_EQ(areaOf(blocks.mapped, lit.ball), 0.0) << "curved";
  EXPECT_NEAR(areaOf(blocks.mapped, lit.floor), 12.0, 1e-4);
  const auto floor = std::find_if(blocks.mapped.parts.begin(), blocks.mapped.parts.end(),
                                  [&](const BlockPart& part) { return part.object == &lit.floor; });
  ASSERT_NE(floor, blocks.mapped.parts.end());
  EXPECT_EQ(floor->range.index_count, 6U) << "two triangles, as it was";
  EXPECT_LT(blocks.lit.indices.size() + blocks.mapped.indices.size(), cut / 2);
}

TEST(FixedBlocks, MaterialsAreWithinAStepOfADisplay) {
  for (double share = 0.0; share <= 1.0; share += 0.001) {
    const PackedMaterial packed = materialOf({{share, share, share}, 0.0, share});
    const double root = packed.share[0] / 255.0;
    EXPECT_NEAR(encoded(static_cast<float>(root * root)), encoded(static_cast<float>(share)), 0.7 / 255.0);
    EXPECT_NEAR(packed.share[3] / 255.0, share, 0.5 / 255.0 + 1e-9);
  }
}

}  // namespace
}  // namespace coherency
