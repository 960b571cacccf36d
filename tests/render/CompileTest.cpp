// Shapes and trees made ready for drawing; needs no OpenGL.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "common/scene/Light.h"
#include "common/scene/Primitives.h"
#include "render_client/compile/CompiledScene.h"
#include "render_client/compile/Refine.h"

namespace coherency {
namespace {

constexpr double kPi = std::numbers::pi;

Coord3 coord(const float (&v)[3]) {
  return {v[0], v[1], v[2]};
}

struct Triangle {
  Coord3 corner[3];
  Coord3 normal[3];
  Coord3 area;  ///< outward by the winding
};

std::vector<Triangle> triangles(const Mesh& mesh) {
  std::vector<Triangle> all;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    Triangle t;
    for (std::size_t c = 0; c < 3; ++c) {
      const MeshVertex& vertex = mesh.vertices.at(mesh.indices[i + c]);
      t.corner[c] = coord(vertex.position);
      t.normal[c] = coord(vertex.normal);
    }
    t.area = 0.5 * cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]);
    all.push_back(t);
  }
  return all;
}

/// By the divergence theorem; negative for a shape turned inside out.
double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : triangles(mesh)) sum += dot(t.corner[0], t.area) / 3.0;
  return sum;
}

void expectClosedAndOutward(const Mesh& mesh, double expected_volume) {
  ASSERT_EQ(mesh.indices.size() % 3, 0U);
  Coord3 open;
  for (const Triangle& t : triangles(mesh)) {
    open += t.area;
    for (const Coord3& n : t.normal) {
      EXPECT_NEAR(norm(n), 1.0, 1e-6);
      EXPECT_GT(dot(n, normalized(t.area)), 0.7);
    }
  }
  EXPECT_LT(norm(open), 1e-5);
  EXPECT_NEAR(volume(mesh), expected_volume, 1e-5 * expected_volume);
}

double polygonArea(int sides, double radius) {
  return 0.5 * sides * radius * radius * std::sin(2.0 * kPi / sides);
}

TEST(MeshBuilder, BoxHasTwoTrianglesAFaceWithTheFacesNormal) {
  const Mesh mesh = buildMesh(*Box({2.0, 3.0, 4.0}).faces());
  EXPECT_EQ(mesh.indices.size(), 12U * 3U);
  EXPECT_EQ(mesh.vertices.size(), 6U * 4U);
  expectClosedAndOutward(mesh, 24.0);
  for (const Triangle& t : triangles(mesh))
    for (const Coord3& n : t.normal) EXPECT_NEAR(dot(n, normalized(t.area)), 1.0, 1e-6);
}

TEST(MeshBuilder, CylindersAreClosedAndOutward) {
  const double area = polygonArea(24, 0.5);
  expectClosedAndOutward(buildMesh(*Cylinder(0.5, 2.0, 24).faces()), 2.0 * area);
  Cylinder tapered;
  tapered.setTapered(0.5, 0.25, 3.0, 24);
  expectClosedAndOutward(buildMesh(*tapered.faces()), area * (1.0 + 0.25 + 0.5));
  Cylinder cone;
  cone.setTapered(0.5, 0.0, 3.0, 24);
  expectClosedAndOutward(buildMesh(*cone.faces()), area);
}

TEST(MeshBuilder, CylinderIsSmoothAroundAndSharpAtItsCaps) {
  constexpr int kSides = 24;
  const Mesh mesh = buildMesh(*Cylinder(0.5, 1.0, kSides).faces());
  EXPECT_EQ(mesh.indices.size() / 3, 4U * kSides - 4U);
  EXPECT_EQ(mesh.vertices.size(), 4U * kSides);
  for (const MeshVertex& v : mesh.vertices) {
    const Coord3 n = coord(v.normal);
    const Coord3 p = coord(v.position);
    if (std::abs(n.y) > 0.5)
      EXPECT_NEAR(n.y * p.y, 0.5, 1e-6);
    else
      EXPECT_NEAR(dot(n, normalized(Coord3{p.x, 0.0, p.z})), 1.0, 1e-6);
  }
}

TEST(MeshBuilder, BallsNormalsPointAwayFromItsMiddle) {
  constexpr int kSides = 16;
  constexpr std::size_t kBands = kSides / 2;
  const Mesh mesh = buildMesh(*Ellipsoid({0.5, 0.5, 0.5}, kSides).faces());
  EXPECT_EQ(mesh.indices.size() / 3, 2U * kSides * (kBands - 1));
  EXPECT_EQ(mesh.vertices.size(), kSides * (kBands - 1) + 2);
  for (const MeshVertex& v : mesh.vertices)
    EXPECT_GT(dot(coord(v.normal), normalized(coord(v.position))), std::cos(3.0 * kPi / 180.0));
  const double ball = 4.0 / 3.0 * kPi * 0.125;
  EXPECT_LT(volume(mesh), ball);
  EXPECT_GT(volume(mesh), 0.9 * ball);
}

/// Two squares that meet along the x axis, their normals `angle` apart.
FaceSet roof(double angle, double crease_angle) {
  const double half = 0.5 * angle;
  const double down = -std::sin(half);
  const double out = std::cos(half);
  FaceSet faces;
  faces.vertices = {{0, 0, 0}, {1, 0, 0}, {0, down, out}, {1, down, out}, {0, down, -out}, {1, down, -out}};
  faces.faces = {{0, 2, 3, 1}, {0, 1, 5, 4}};
  faces.smooth = true;
  faces.crease_angle = crease_angle;
  return faces;
}

TEST(MeshBuilder, CreaseAngleDecidesWhichEdgesAreSharp) {
  const double degree = kPi / 180.0;
  const Mesh smooth = buildMesh(roof(60.0 * degree, 61.0 * degree));
  ASSERT_EQ(smooth.vertices.size(), 6U);
  EXPECT_NEAR(smooth.vertices[smooth.indices[0]].normal[1], 1.0, 1e-6)
      << "along the ridge, between both slopes";
  const Mesh sharp = buildMesh(roof(60.0 * degree, 59.0 * degree));
  ASSERT_EQ(sharp.vertices.size(), 8U);
  for (const MeshVertex& v : sharp.vertices) EXPECT_NEAR(v.normal[1], std::cos(30.0 * degree), 1e-6);
}

TEST(MeshBuilder, NormalsDoNotDependOnHowFacesAreCutIntoTriangles) {
  FaceSet cube = *Box().faces();
  const std::vector<std::uint32_t> square = cube.faces.front();
  cube.faces.front() = {square[0], square[1], square[2]};
  cube.faces.push_back({square[0], square[2], square[3]});
  cube.smooth = true;
  cube.crease_angle = 2.0;
  const Mesh mesh = buildMesh(cube);
  ASSERT_EQ(mesh.vertices.size(), 8U);
  for (const MeshVertex& v : mesh.vertices)
    EXPECT_NEAR(dot(coord(v.normal), normalized(coord(v.position))), 1.0, 1e-6);
}

TEST(MeshBuilder, KeepsItsPrecisionFarFromItsFrame) {
  const Coord3 far{1e6, -2e6, 3e6};
  FaceSet faces = *Box({0.001, 0.002, 0.003}).faces();
  for (Coord3& v : faces.vertices) v += far;
  const Mesh mesh = buildMesh(faces);
  EXPECT_LT(norm(mesh.origin - far), 1e-9);
  for (const MeshVertex& v : mesh.vertices) {
    EXPECT_NEAR(std::abs(v.position[0]), 0.0005, 1e-9);
    EXPECT_NEAR(std::abs(v.position[1]), 0.001, 1e-9);
    EXPECT_NEAR(std::abs(v.position[2]), 0.0015, 1e-9);
  }
}

TEST(MeshBuilder, LeavesOutWhatHasNoArea) {
  FaceSet faces;
  faces.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  faces.faces = {{}, {0}, {0, 1}, {0, 1, 1}, {0, 1, 3}, {0, 1, 2}};
  for (const bool smooth : {false, true}) {
    faces.smooth = smooth;
    const Mesh mesh = buildMesh(faces);
    ASSERT_EQ(mesh.indices.size(), 3U);
    for (const MeshVertex& v : mesh.vertices) EXPECT_NEAR(v.normal[2], 1.0, 1e-6);
  }
  EXPECT_TRUE(buildMesh({}).indices.empty());
}

/// Shows what it is given, unchecked.
class Raw : public VRObject {
 public:
  Raw(std::string name, FaceSet faces) : VRObject(std::move(name)), faces_(std::move(faces)) {}
  const FaceSet* faces() const override { return &faces_; }

 private:
  FaceSet faces_;
};

TEST(CompiledScene, RefusesAnIndexWithoutVertexNamingObjectFaceAndVertex) {
  FaceSet faces;
  faces.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  faces.faces = {{0, 1, 2}, {0, 1, 3}};
  VRObject root("world");
  Raw broken("broken", faces);
  root.addMember(&broken);
  try {
    const CompiledScene scene(root, {});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "world/broken: face 1 names vertex 3 of a shape that has 3");
  }
}

TEST(CompiledScene, FollowsWhatMovesDownTheTree) {
  VRObject root("world");
  VRObject group("group");
  Box box({1.0, 2.0, 3.0}, "box");
  Ellipsoid ball({0.1, 0.1, 0.1}, 8, "ball");
  root.addMember(&group);
  group.addMember(&box);
  box.addMember(&ball);
  box.attach(Moving{});
  group.setPosition(5.0, 0.0, 0.0);
  CompiledScene scene(root, {});
  EXPECT_TRUE(scene.fixed().lit.blocks.empty());
  EXPECT_TRUE(scene.fixed().mapped.blocks.empty());
  const auto& moving = scene.moving();
  ASSERT_EQ(moving.drawables.size(), 2U) << "a group shows nothing itself";

  box.setTransform(TransformMatrix::translation({0.0, 1.0, 0.0}) * TransformMatrix::rotationY(0.5));
  ball.scale({2.0, 3.0, 4.0});
  scene.update();
  for (const VRObject* object : {static_cast<VRObject*>(&box), static_cast<VRObject*>(&ball)}) {
    const Drawable& drawable = moving.drawables[object == &box ? 0 : 1];
    EXPECT_EQ(drawable.faces, object->faces());
    EXPECT_TRUE(scene.worldTransform(drawable) == object->globalTransform()) << object->name();
  }
  EXPECT_GE(moving.drawables[0].range.index_count, 36U);
  EXPECT_EQ(moving.drawables[1].range.first_index, moving.drawables[0].range.index_count);
  EXPECT_EQ(moving.indices.size(),
            moving.drawables[1].range.first_index + moving.drawables[1].range.index_count);
  for (std::uint32_t i = 0; i < moving.drawables[1].range.index_count; ++i)
    EXPECT_LT(
        moving.drawables[1].range.first_vertex + moving.indices[moving.drawables[1].range.first_index + i],
        moving.vertices.size());
}

/// Between an object's origin and its triangles in a block; their corners are expected within `reach` of it.
double volumeInside(const auto& fixed, const BlockPart& part, double reach) {
  const Block& block = fixed.blocks[part.block];
  const TransformMatrix t_object_world = part.object->globalTransform().inverse();
  double volume = 0.0;
  for (std::uint32_t i = 0; i < part.range.index_count; i += 3) {
    Coord3 corner[3];
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t vertex = block.range.first_vertex + fixed.indices[part.range.first_index + i + c];
      const Coord3 at = block.origin + coord(fixed.vertices[vertex].position);
      corner[c] = at - part.object->globalPosition();
      EXPECT_LE(norm(t_object_world.point(at)), reach) << "within its box";
    }
    volume += dot(corner[0], cross(corner[1], corner[2])) / 6.0;
  }
  return volume;
}

TEST(CompiledScene, WhatNeverMovesStandsInTheWorldWhereItsTransformsPutIt) {
  VRObject root("world");
  Box table({1.0, 0.1, 0.6}, "table");
  Box brick({0.1, 0.2, 0.3}, "brick");
  Box mirrored({0.1, 0.2, 0.3}, "mirrored");
  Box mover({0.1, 0.1, 0.1}, "mover");
  root.addMember(&table);
  table.addMember(&brick);
  table.addMember(&mirrored);
  root.addMember(&mover);
  mover.attach(Moving{});
  table.setTransform(TransformMatrix::translation({1e6, 2.0, 3.0}) * TransformMatrix::rotationY(0.5));
  brick.setTransform(TransformMatrix::translation({0.0, 1.0, 0.0}) *
                     TransformMatrix::scaling({2.0, 1.0, 1.0}));
  mirrored.setTransform(TransformMatrix::scaling({-1.0, 1.0, 1.0}));
  const CompiledScene scene(root, {});
  EXPECT_EQ(scene.fixed().object_count, 3U);
  EXPECT_EQ(scene.moving().drawables.size(), 1U);
  std::map<const VRObject*, double> volume;  // some of an object's faces may be lit from the lightmap
  for (const BlockPart& part : scene.fixed().lit.parts)
    volume[part.object] += volumeInside(scene.fixed().lit, part, 0.6);
  for (const BlockPart& part : scene.fixed().mapped.parts)
    volume[part.object] += volumeInside(scene.fixed().mapped, part, 0.6);
  EXPECT_FALSE(scene.fixed().mapped.parts.empty()) << "the table is cut for its light";
  for (const auto& [object, expected] :
       std::map<const VRObject*, double>{{&table, 0.06}, {&brick, 0.012}, {&mirrored, 0.006}})
    EXPECT_NEAR(volume[object], expected, 1e-6) << object->name() << " is turned right and has its size";
}

/// Every edge of the surface is shared by two triangles that run along it in opposite directions.
bool isClosed(const Mesh& mesh) {
  std::map<std::array<float, 6>, int> edges;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const float* a = mesh.vertices[mesh.indices[i]].position;
    const float* b = mesh.vertices[mesh.indices[next]].position;
    ++edges[{a[0], a[1], a[2], b[0], b[1], b[2]}];
    --edges[{b[0], b[1], b[2], a[0], a[1], a[2]}];
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

TEST(Refine, CutsEveryLongEdgeAndOpensNoGap) {
  Box box({3.0, 0.2, 1.1});
  Mesh mesh = buildMesh(*box.faces());
  const std::size_t before = mesh.indices.size();
  refine(mesh, 0.4);
  EXPECT_GT(mesh.indices.size(), before);
  EXPECT_TRUE(isClosed(mesh));
  double area = 0.0;
  for (const Triangle& t : triangles(mesh)) {
    area += norm(t.area);
    for (int c = 0; c < 3; ++c) EXPECT_LE(norm(t.corner[c] - t.corner[(c + 1) % 3]), 0.4 + 1e-6);
  }
  EXPECT_NEAR(area, 2.0 * (3.0 * 0.2 + 3.0 * 1.1 + 0.2 * 1.1), 1e-5);
}

TEST(Refine, LeavesWhatIsFineEnough) {
  Mesh mesh = buildMesh(*Box({0.2, 0.2, 0.2}).faces());
  const auto before = mesh.indices;
  refine(mesh, 0.4);
  EXPECT_EQ(mesh.indices.size(), before.size());
  EXPECT_EQ(mesh.vertices.size(), 24U);
}

}  // namespace
}  // namespace coherency
