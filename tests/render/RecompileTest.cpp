// What is compiled stays true: moves, changes and deaths of what was compiled are noticed and drawn, or
// refused.

#include <stdexcept>

#include <epoxy/gl.h>

#include "tests/render/Support.h"

namespace coherency {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

/// A red box on the left that the tests change, and a green one on the right that stays; both shine.
class Recompile : public DrawingTest {
 protected:
  Image drawn() { return picture(*renderer, {&view, 1}); }
  /// What a renderer made now draws.
  Image fresh() { return picture(scene, view); }
  void make() { renderer.emplace(scene, scene.illumination(), kWidth, kHeight); }
  double redAt() { return spot(drawn(), Red).x; }

  TestScene scene{"scene"};
  Box& box = scene.add<Box>({-0.5, 0.0, -2.0}, kRed, Coord3{0.3, 0.3, 0.3}, "box");
  Box& other = scene.add<Box>({0.5, 0.0, -2.0}, kGreen, Coord3{0.3, 0.3, 0.3}, "other");
  const EyeView view = lookingAhead({}, kWidth, kHeight);
  std::optional<Renderer> renderer;
};

TEST_F(Recompile, WhatRestsIsCompiledOnce) {
  make();
  const Image first = drawn();
  box.setPosition(box.transform().origin());
  box.setMaterial(kRed);
  EXPECT_EQ(shareDiffering(drawn(), first, 0), 0.0);
  EXPECT_EQ(renderer->compilations(), 1U);
  EXPECT_EQ(renderer->report().fixed.count, 2U);
}

TEST_F(Recompile, WhatIsMovedIsDrawnWhereItIsFromTheNextFrameOn) {
  make();
  const Image before = drawn();
  box.setPosition(-0.2, 0.3, -2.0);
  const Image after = drawn();
  EXPECT_GT(shareDiffering(after, before, 0), 0.01);
  EXPECT_EQ(shareDiffering(after, fresh(), 0), 0.0);
  EXPECT_EQ(renderer->compilations(), 2U);
  EXPECT_EQ(renderer->report().found, std::vector<std::string>{"scene/box"});
  EXPECT_EQ(renderer->report().found_to_move.count, 1U);
  EXPECT_EQ(renderer->report().fixed.count, 1U);
}

TEST_F(Recompile, WhatWasFoundToMoveMovesForNothing) {
  make();
  for (int step = 0; step < 5; ++step) {
    box.setPosition(-0.5 + 0.1 * step, 0.1 * step, -2.0);
    EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0) << step;
  }
  EXPECT_EQ(renderer->compilations(), 2U);
  other.setPosition(0.5, 0.4, -2.0);
  EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0);
  box.setPosition(-0.5, -0.3, -2.0);
  EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0);
  EXPECT_EQ(renderer->compilations(), 3U) << "the box is still known to move";
  EXPECT_EQ(renderer->report().found.size(), 2U);
}

TEST_F(Recompile, WhatHoldsItMovesIt) {
  VRObject group("group");
  scene.removeMember(&box);
  group.addMember(&box);
  scene.addMember(&group);
  box.attach(Fixed{});
  make();
  drawn();
  group.setPosition(0.1, 0.2, -0.5);
  EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0);
  EXPECT_EQ(renderer->report().found, std::vector<std::string>{"scene/group"});
  EXPECT_EQ(renderer->report().found_to_move.count, 1U) << "the box is part of it";
}

TEST_F(Recompile, WhatIsDeclaredFixedRefuses) {
  box.attach(Fixed{});
  make();
  const Image before = drawn();
  try {
    box.setPosition(0.0, 1.0, -2.0);
    FAIL() << "it moved";
  } catch (const std::logic_error& error) {
    EXPECT_NE(std::string(error.what()).find("'scene/box'"), std::string::npos) << error.what();
  }
  EXPECT_EQ(shareDiffering(drawn(), before, 0), 0.0);
  EXPECT_EQ(renderer->compilations(), 1U);
  EXPECT_EQ(renderer->report().declared_fixed, 1U);
  renderer.reset();
  box.setPosition(0.0, 1.0, -2.0);  // nobody is left to mind
}

TEST_F(Recompile, WhatIsDeclaredMovingNeedsNoCompilation) {
  box.attach(Moving{});
  make();
  drawn();
  box.setPosition(-0.2, 0.3, -2.0);
  box.setMaterial(kBlue);
  EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0);
  EXPECT_EQ(renderer->compilations(), 1U);
}

TEST_F(Recompile, WhatIsRepaintedShowsItWithoutCompilation) {
  make();
  drawn();
  box.setMaterial(kBlue);
  EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0);
  box.setMaterial(glow(1.0, 0.0, 1.0));
  other.setMaterial(kRed);
  box.setMaterial(kGreen);
  EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0);
  EXPECT_EQ(renderer->compilations(), 1U);
}

/// A large flat face has its light in the lightmap, a ball at its vertices.
TEST_F(Recompile, WhatIsRepaintedKeepsItsLight) {
  scene.addLight({{0.0, 1.5, -2.0}, {1.0, 1.0, 1.0}, 2.0});
  scene.setAmbient({0.2, 0.2, 0.2}, {0.2, 0.2, 0.2});
  Box& floor = scene.add<Box>({0.0, -0.6, -2.0}, matt(0.2, 0.6, 0.2), Coord3{4.0, 0.1, 4.0});
  Ellipsoid& ball = scene.add<Ellipsoid>({0.0, -0.2, -2.0}, matt(0.6, 0.2, 0.2), Coord3{0.2, 0.2, 0.2});
  make();
  ASSERT_GT(renderer->report().mapped.vertices, 0U);
  const Image before = drawn();
  floor.setMaterial(matt(0.4, 0.1, 0.5));
  ball.setMaterial(matt(0.1, 0.5, 0.5));
  const Image after = drawn();
  EXPECT_GT(shareDiffering(after, before, 20), 0.1);
  EXPECT_LT(shareDiffering(after, fresh(), 12), 0.01) << "but for the colour it throws on others";
  EXPECT_EQ(renderer->compilations(), 1U);
}

TEST_F(Recompile, WhatShinesNoMoreGetsItsLight) {
  scene.setAmbient({0.5, 0.5, 0.5}, {0.5, 0.5, 0.5});
  make();
  drawn();
  box.setMaterial(matt(1.0, 0.0, 0.0));
  EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0);
  EXPECT_GT(spot(drawn(), Red).light, 10.0) << "it is not black";
  EXPECT_EQ(renderer->compilations(), 2U);
  box.setMaterial(kRed);
  box.setMaterial(matt(0.5, 0.0, 0.0));
  EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0);
  EXPECT_EQ(renderer->compilations(), 2U) << "it has light now";
}

TEST_F(Recompile, NewShapesAreDrawn) {
  for (const bool moves : {false, true}) {
    if (moves) box.attach(Moving{});
    make();
    drawn();
    box.setSize(moves ? Coord3{0.1, 0.5, 0.1} : Coord3{0.5, 0.1, 0.1});
    EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0) << moves;
    EXPECT_EQ(renderer->compilations(), 2U) << moves;
  }
}

TEST_F(Recompile, WhatIsAddedAndRemovedIsDrawnAndNot) {
  for (const bool moves : {false, true}) {
    if (moves) box.attach(Moving{});
    make();
    drawn();
    {
      Box more({0.1, 0.1, 0.1}, "more");
      more.setMaterial(kBlue);
      more.setPosition(0.0, 0.3, 0.0);
      box.addMember(&more);
      const Image with = drawn();
      EXPECT_GT(spot(with, Blue).light, 1.0) << moves;
      EXPECT_EQ(shareDiffering(with, fresh(), 0), 0.0) << moves;
      box.removeMember(&more);
      EXPECT_EQ(spot(drawn(), Blue).light, 0.0) << moves;
      box.addMember(&more);
      drawn();
    }
    EXPECT_EQ(spot(drawn(), Blue).light, 0.0) << "it died, " << moves;
    EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0) << moves;
    EXPECT_EQ(renderer->compilations(), 5U) << moves;
  }
}

TEST_F(Recompile, WhatWasFoundToMoveMayDie) {
  auto brief = std::make_unique<Box>(Coord3{0.2, 0.2, 0.2}, "brief");
  brief->setMaterial(kBlue);
  brief->setPosition(0.0, 0.0, -2.0);
  scene.addMember(brief.get());
  make();
  drawn();
  brief->setPosition(0.0, 0.1, -2.0);
  EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0);
  brief->setPosition(0.0, 0.2, -2.0);
  brief->setMaterial(kGreen);
  brief.reset();
  EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0);
  EXPECT_TRUE(renderer->report().found.empty());
}

TEST_F(Recompile, IdsAreOfTheTreeAsItIs) {
  make();
  renderer->drawIds({&view, 1});
  scene.removeMember(&other);
  box.setPosition(0.0, 0.0, -2.0);
  const IdImage ids = renderer->drawIds({&view, 1});
  EXPECT_EQ(ids.objects, std::vector<const VRObject*>{&box});
  EXPECT_EQ(ids.ids[kHeight / 2 * kWidth + kWidth / 2], 1U);
  EXPECT_EQ(renderer->compilations(), 2U);
}

TEST_F(Recompile, WhatCannotBeCompiledIsSaidUntilItIsMended) {
  make();
  const Image before = drawn();
  box.attach(Fixed{});
  box.attach(Moving{});
  other.setSize({0.1, 0.1, 0.1});
  EXPECT_THROW(drawn(), std::invalid_argument);
  EXPECT_THROW(drawn(), std::invalid_argument) << "not drawn wrong the second time either";
  scene.removeMember(&box);
  EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0);
  EXPECT_EQ(renderer->compilations(), 2U);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Recompile, ATreeMayDieBeforeItsRenderer) {
  auto mortal = std::make_unique<TestScene>();
  mortal->add<Box>({0.0, 0.0, -2.0}, kRed);
  mortal->addMoving<Box>({1.0, 0.0, -2.0}, kRed);
  Renderer bereaved(*mortal, mortal->illumination(), kWidth, kHeight);
  picture(bereaved, {&view, 1});
  mortal.reset();
  EXPECT_THROW(bereaved.draw({&view, 1}), std::logic_error);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(Recompile, TwoRenderersOfOneTreeBothFollowIt) {
  make();
  Renderer second(scene, scene.illumination(), kWidth, kHeight);
  drawn();
  picture(second, {&view, 1});
  box.setPosition(-0.3, 0.2, -2.0);
  EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0);
  box.setMaterial(kBlue);
  EXPECT_EQ(shareDiffering(picture(second, {&view, 1}), fresh(), 0), 0.0);
  EXPECT_EQ(shareDiffering(drawn(), fresh(), 0), 0.0);
  other.setMaterial(kRed);
  renderer.reset();
  EXPECT_EQ(shareDiffering(picture(second, {&view, 1}), fresh(), 0), 0.0);
  EXPECT_EQ(second.compilations(), 2U);
}

/// OpenGL's objects there are, of those that `is` knows.
int alive(GLboolean (*is)(GLuint)) {
  int count = 0;
  for (GLuint name = 1; name < (1U << 20); ++name) count += is(name) == GL_TRUE ? 1 : 0;
  return count;
}

/// Texels from left to right of all maps of depths that there are.
int depthMapWidth() {
  int sum = 0;
  for (GLuint name = 1; name < (1U << 20); ++name) {
    if (glIsTexture(name) != GL_TRUE) continue;
    GLint depth_bits = 0;
    GLint width = 0;
    glGetTextureLevelParameteriv(name, 0, GL_TEXTURE_DEPTH_SIZE, &depth_bits);
    glGetTextureLevelParameteriv(name, 0, GL_TEXTURE_WIDTH, &width);
    if (depth_bits > 0) sum += width;
  }
  return sum;
}

TEST_F(Recompile, WhereThereIsNoRobotTheShadowMapHasOneTile) {
  SeenScene seen;
  seen.addMoving<Box>({0.0, 0.0, -2.0}, kRed);
  const RendererSettings settings{.shadow_resolution = 64};
  const int before = depthMapWidth();
  const Renderer of_scene(seen, kWidth, kHeight, settings);
  EXPECT_EQ(depthMapWidth() - before, 64);
  const Renderer of_any_tree(seen, seen.illumination(), kWidth, kHeight, settings);
  EXPECT_EQ(depthMapWidth() - before, 64 + 128) << "which does not say what it has";
}

TEST_F(Recompile, WhatNothingNeedsIsNotMade) {
  const auto made = [&](const TestScene& of) {
    const int textures = alive(glIsTexture);
    const int programs = alive(glIsProgram);
    const Renderer one(of, of.illumination(), kWidth, kHeight);
    return std::pair{alive(glIsTexture) - textures, alive(glIsProgram) - programs};
  };
  const TestScene nothing;
  const auto [textures, programs] = made(nothing);
  EXPECT_EQ(made(scene), (std::pair{textures, programs + 1})) << "fixed, in no shadow";
  box.attach(Moving{});
  EXPECT_EQ(made(scene), (std::pair{textures + 1, programs + 4})) << "fixed, in shadow too, moving, the map";
  other.attach(Moving{});
  EXPECT_EQ(made(scene), (std::pair{textures + 1, programs + 2})) << "moving, the map";
}

}  // namespace
}  // namespace coherency
