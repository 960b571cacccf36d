// What a compilation says of itself, against what was put in; needs no OpenGL.

#include <cmath>

#include <gtest/gtest.h>

#include "common/scene/Light.h"
#include "render_client/compile/CompiledScene.h"
#include "tests/render/Support.h"

namespace coherency {
namespace {

struct ReportTest : testing::Test {
  CompileReport compiled(const ObjectSet& found = {}) {
    return CompiledScene(scene, scene.illumination(), {}, found).report();
  }
  TestScene scene{"scene"};
};

/// A face without area, which a Polyhedron would refuse.
struct Needle : VRObject {
  const FaceSet* faces() const override { return &set; }
  FaceSet set{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}, {}};
};

void expectObjects(const CompileReport::Objects& objects, std::size_t count, std::size_t polygons) {
  EXPECT_EQ(objects.count, count);
  EXPECT_EQ(objects.polygons, polygons);
}

TEST_F(ReportTest, OfThreeBoxes) {
  for (const double x : {-1.0, 0.0, 1.0}) scene.add<Box>({x, 0.0, 0.0}, kRed, Coord3{0.2, 0.2, 0.2});
  const CompileReport report = compiled();
  expectObjects(report.fixed, 3, 18);
  expectObjects(report.declared_moving, 0, 0);
  EXPECT_EQ(report.without_faces, 1U) << "the scene itself";
  EXPECT_EQ(report.objects(), 3U);
  EXPECT_EQ(report.triangles_before, 36U);
  EXPECT_EQ(report.triangles_cut, 36U) << "what shines is not cut for light";
  EXPECT_EQ(report.lit.blocks, 1U);
  EXPECT_EQ(report.lit.triangles, 36U);
  EXPECT_EQ(report.lit.vertices, 72U);
  EXPECT_EQ(report.mapped.blocks + report.moving.blocks + report.charts, 0U);
  EXPECT_EQ(report.lightmap_width, 0);
  EXPECT_EQ(report.bytes, 72U * 24U + 108U * 4U) << "a vertex has three floats, light and material";
  EXPECT_NEAR(report.largest_radius, std::hypot(1.1, 0.1, 0.1), 1e-6);
  EXPECT_EQ(report.lamps + report.enclosures, 0U);
}

TEST_F(ReportTest, SaysWhoMovesAndHowThatIsKnown) {
  Box& fixed = scene.add<Box>({0.0, 0.0, 0.0}, kRed, Coord3{0.2, 0.2, 0.2}, "fixed");
  fixed.attach(Fixed{});
  Box& found = scene.add<Box>({1.0, 0.0, 0.0}, kRed, Coord3{0.2, 0.2, 0.2}, "found");
  Rectangle part(0.1, 0.1);
  found.addMember(&part);
  scene.addMoving<Box>({2.0, 0.0, 0.0}, kRed, Coord3{0.2, 0.2, 0.2}, "moving");
  const CompileReport report = compiled({&found, &fixed});
  expectObjects(report.fixed, 1, 6);
  EXPECT_EQ(report.declared_fixed, 1U) << "and what is declared is not looked for";
  expectObjects(report.found_to_move, 2, 7);
  EXPECT_EQ(report.found, std::vector<std::string>{"scene/found"});
  expectObjects(report.declared_moving, 1, 6);
  EXPECT_EQ(report.moving.blocks, 2U);
  EXPECT_EQ(report.moving.triangles, 12U + 2U + 12U);
}

TEST_F(ReportTest, SaysWhatWasLeftOutAndWhy) {
  scene.add<Box>({0.0, 0.0, 0.0}, kRed).setOrientation(TransformMatrix::scaling({1.0, 0.0, 1.0}));
  Needle needle;
  VRObject group;
  scene.addMember(&needle);
  scene.addMember(&group);
  const CompileReport report = compiled();
  expectObjects(report.fixed, 0, 0);
  expectObjects(report.flat, 1, 6);
  expectObjects(report.without_area, 1, 1);
  EXPECT_EQ(report.without_faces, 2U);
  EXPECT_EQ(report.bytes, 0U);
  EXPECT_NE(describe(report).find("squashes"), std::string::npos);
}

TEST_F(ReportTest, CountsWhatIsCutForItsLightAndItsLightmap) {
  scene.addLight({{0.0, 1.0, 0.0}, {1.0, 1.0, 1.0}, 2.0});
  scene.add<Box>({0.0, -0.5, 0.0}, matt(0.5, 0.5, 0.5), Coord3{4.0, 0.1, 4.0});
  const CompileReport report = compiled();
  EXPECT_EQ(report.triangles_before, 12U);
  EXPECT_GT(report.triangles_cut, 100U);
  EXPECT_GT(report.mapped.triangles, 0U);
  EXPECT_LE(report.mapped.triangles, 12U) << "drawn as they were before";
  EXPECT_GT(report.charts, 0U);
  const auto texels =
      static_cast<std::size_t>(report.lightmap_width) * static_cast<std::size_t>(report.lightmap_height);
  EXPECT_EQ(report.bytes, report.lit.vertices * 24 + report.mapped.vertices * 24 + texels * 8 +
                              12 * (report.lit.triangles + report.mapped.triangles));
  EXPECT_EQ(report.lamps, 1U);
}

/// Corners that no float has, seen from where block and eye have other rounding.
TEST_F(ReportTest, NoCornerIsFurtherOffThanItsBound) {
  const double third = 1.0 / 3.0;
  for (int i = 0; i < 50; ++i)
    scene
        .add<Box>({1e6 + third * i, third * (i % 7), -third * (i % 11)}, kRed,
                  Coord3{0.1 * third, 0.7 * third, third})
        .setOrientation(TransformMatrix::rotationX(0.1 * i));
  const CompiledScene compiled(scene, {});
  double worst = 0.0;
  double worst_share = 0.0;
  for (const BlockPart& part : compiled.fixed().lit.parts) {
    const Block& block = compiled.fixed().lit.blocks[part.block];
    const TransformMatrix t_world_object = part.object->globalTransform();
    for (std::uint32_t v = 0; v < part.vertex_count; ++v) {
      const float(&p)[3] = compiled.fixed().lit.vertices[part.range.first_vertex + v].position;
      const Coord3 at = block.origin + Coord3{p[0], p[1], p[2]};
      const Coord3 eye = at + Coord3{0.1 * third, 0.2 * third, third};
      const glm::vec3 offset((block.origin - eye).glm());
      const glm::vec3 drawn = offset + glm::vec3(p[0], p[1], p[2]);
      double off = 1.0;
      for (const Coord3& corner : part.object->faces()->vertices)
        off = std::min(off, norm(t_world_object.point(corner) - eye - Coord3(glm::dvec3(drawn))));
      worst = std::max(worst, off);
      worst_share = std::max(worst_share, off / compiled.report().positionError(norm(at - eye)));
    }
  }
  EXPECT_GT(worst, 1e-9) << "there is something to bound";
  EXPECT_LE(worst_share, 1.0);
  EXPECT_GT(worst_share, 0.02) << "the bound says something";
}

TEST_F(ReportTest, IsToldInWords) {
  scene.add<Box>({0.0, 0.0, 0.0}, kRed, Coord3{0.2, 0.2, 0.2}, "box");
  Box& found = scene.add<Box>({1.0, 0.0, 0.0}, kRed, Coord3{0.2, 0.2, 0.2}, "found");
  const std::string text = describe(compiled({&found}));
  for (const char* part : {"fixed                   1 objects         6 polygons",
                           "found to move           1 objects         6 polygons", "scene/found",
                           "lightmap        none", "bytes an object", "position error"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

}  // namespace
}  // namespace coherency
