// Levels of detail as they are compiled; needs no OpenGL.

#include <gtest/gtest.h>

#include "common/scene/Primitives.h"
#include "render_client/compile/CompiledScene.h"

namespace coherency {
namespace {

Coord3 coord(const float (&v)[3]) {
  return {v[0], v[1], v[2]};
}

TEST(BuildMesh, MakesLevelsOfTheVerticesThatAreThereAndKeepsCapsSharp) {
  const Cylinder cylinder(0.5, 1.0, 24);
  FaceSet without = *cylinder.faces();
  without.coarser.clear();
  const Mesh mesh = buildMesh(*cylinder.faces());
  EXPECT_EQ(mesh.vertices.size(), buildMesh(without).vertices.size());
  EXPECT_EQ(mesh.indices, buildMesh(without).indices);
  ASSERT_EQ(mesh.coarser.size(), 2U);
  for (std::size_t level = 0; level < 2; ++level) {
    const std::vector<std::uint32_t>& indices = mesh.coarser[level].indices;
    const std::size_t sides = level == 0 ? 12 : 6;
    ASSERT_EQ(indices.size(), 3 * (2 * sides + 2 * (sides - 2)));
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      const auto corner = [&](std::size_t c) { return coord(mesh.vertices.at(indices[i + c]).position); };
      const Coord3 up = normalized(cross(corner(1) - corner(0), corner(2) - corner(0)));
      for (std::size_t c = 0; c < 3; ++c) {
        const Coord3 normal = coord(mesh.vertices[indices[i + c]].normal);
        EXPECT_GT(dot(normal, up), level == 0 ? 0.96 : 0.86) << "of the cap's or the side's own";
      }
    }
  }
}

/// Shows what it is given, unchecked.
class Raw : public VRObject {
 public:
  explicit Raw(FaceSet faces) : VRObject("raw"), faces_(std::move(faces)) {}
  const FaceSet* faces() const override { return &faces_; }

 private:
  FaceSet faces_;
};

TEST(CompiledScene, RefusesLevelsThatCannotBeDrawn) {
  const auto message = [](FaceSet faces) -> std::string {
    Raw raw(std::move(faces));
    try {
      const CompiledScene scene(raw, {});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  FaceSet faces = *Cylinder(1.0, 1.0, 24).faces();
  faces.coarser[1].faces[2][1] = 48;
  EXPECT_EQ(message(faces), "raw: coarser level 1: face 2 names vertex 48 of a shape that has 48");
  faces = *Cylinder(1.0, 1.0, 24).faces();
  std::swap(faces.coarser[0].error, faces.coarser[1].error);
  EXPECT_NE(message(faces).find("raw: coarser level 1 has an error of"), std::string::npos);
}

/// Of a block's triangles, about its origin.
double volume(const BlockSurfaces<LitVertex>& surfaces, const Block& block, std::uint32_t first,
              std::uint32_t count) {
  double sum = 0.0;
  for (std::uint32_t i = first; i < first + count; i += 3) {
    Coord3 corner[3];
    for (std::uint32_t c = 0; c < 3; ++c)
      corner[c] = coord(surfaces.vertices.at(block.range.first_vertex + surfaces.indices.at(i + c)).position);
    sum += dot(corner[0], cross(corner[1], corner[2])) / 6.0;
  }
  return sum;
}

TEST(CompiledScene, BlocksHaveLevelsOfTheObjectsInThem) {
  VRObject root("world");
  Ellipsoid small({0.003, 0.003, 0.003}, 12, "small");
  Ellipsoid large({0.05, 0.05, 0.05}, 12, "large");
  Box box({0.2, 0.2, 0.2}, "box");
  root.addMember(&small);
  root.addMember(&large);
  root.addMember(&box);
  large.setTransform(TransformMatrix::translation({0.5, 0.0, 0.0}) *
                     TransformMatrix::scaling({-1.0, 1.0, 1.0}));
  box.setPosition(0.0, 0.0, 0.5);
  const CompiledScene scene(root, {});
  const BlockSurfaces<LitVertex>& lit = scene.fixed().lit;
  ASSERT_EQ(lit.blocks.size(), 1U);
  const Block& block = lit.blocks[0];
  ASSERT_EQ(block.coarser.size(), 2U) << "nothing comes to the second threshold";
  const double errors[] = {0.25 * 0.003, 0.25 * 0.05};  // of 6 sides: a quarter of the radius
  double last = volume(lit, block, block.range.first_index, block.range.index_count);
  std::uint32_t finer = block.range.index_count;
  for (std::size_t i = 0; i < 2; ++i) {
    const LevelRange& level = block.coarser[i];
    EXPECT_NEAR(level.error, errors[i], 1e-9);
    EXPECT_LT(level.index_count, finer);
    const double now = volume(lit, block, level.first_index, level.index_count);
    EXPECT_LT(now, last) << "no triangle is missing or turned: each level lies in the finer one";
    EXPECT_GT(now, 0.95 * last);
    finer = level.index_count;
    last = now;
  }
}

TEST(CompiledScene, WhatWasCutForItsLightAndWhatIsFlatHaveNoCoarserLevels) {
  VRObject root("world");
  Cylinder tall(0.05, 3.0, 24, "cut to half a metre");
  Box box({0.2, 0.2, 0.2}, "box");
  box.setPosition(20.0, 0.0, 0.0);
  root.addMember(&tall);
  root.addMember(&box);
  const CompiledScene scene(root, {});
  for (const Block& block : scene.fixed().lit.blocks) EXPECT_TRUE(block.coarser.empty());
}

TEST(CompiledScene, WhatMovesIsAsCoarseAsItsScaleAllows) {
  VRObject root("world");
  Cylinder pipe(0.05, 3.0, 24, "pipe");
  pipe.attach(Moving{});
  root.addMember(&pipe);
  CompiledScene scene(root, {});
  const Drawable& drawable = scene.moving().drawables.at(0);
  ASSERT_EQ(drawable.coarser.size(), 2U);
  const double error = drawable.coarser[0].error;
  EXPECT_EQ(scene.coarsestWithin(0.99 * error, drawable), drawable.range);
  EXPECT_EQ(scene.coarsestWithin(1.01 * error, drawable).first_index, drawable.coarser[0].first_index);
  pipe.scale({3.0, 1.0, 1.0});
  scene.update();
  EXPECT_EQ(scene.coarsestWithin(2.99 * error, drawable), drawable.range);
  EXPECT_EQ(scene.coarsestWithin(3.01 * error, drawable).first_index, drawable.coarser[0].first_index);
  for (const LevelRange& level : drawable.coarser)  // cut for its lamps' light, as the finest was
    for (std::uint32_t i = 0; i < level.index_count; ++i)
      EXPECT_LT(drawable.range.first_vertex + scene.moving().indices.at(level.first_index + i),
                scene.moving().vertices.size());
}

}  // namespace
}  // namespace coherency
