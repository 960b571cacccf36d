// Levels of detail: both eyes choose the same, and nothing is off by more pixels than was allowed.

#include <cmath>
#include <numbers>
#include <random>

#include "common/motion/SampleGate.h"
#include "render_client/compile/CompiledScene.h"
#include "render_client/draw/EyeViews.h"
#include "tests/render/Support.h"

namespace coherency {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

class Detail : public DrawingTest {
 protected:
  double between(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  Coord3 within(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

  /// Anywhere, looking anywhere.
  void poseAnyhow(Scene& scene) {
    const Rig& rig = scene.human().rig();
    MasterReading reading;
    reading.si = neutralPosture(rig);
    for (const Dof dof : {Dof::HeadX, Dof::HeadY, Dof::HeadZ}) reading.si[index(dof)] += between(-0.1, 0.1);
    for (const Dof dof : {Dof::HeadYaw, Dof::HeadPitch, Dof::HeadRoll})
      reading.si[index(dof)] += between(-0.4, 0.4);
    WorldState state = scene.initialState();
    state.master.base = basePose(between(-30.0, 30.0), between(-30.0, 30.0), between(-3.0, 3.0));
    scene.apply(state, SampleGate(neutralPosture(rig)).admit(reading, 1, 0));
  }

 private:
  std::mt19937_64 engine_{11};
};

EyeView viewOf(const Scene& scene, EyeChoice eye) {
  std::vector<EyeView> views;
  eyeViews(scene, Mode::Operator, {}, eye, kWidth, kHeight, views);
  return views.front();
}

/// That of the middle between the eyes, brought to a place, upright.
EyeView viewFrom(const Coord3& at) {
  const SeenScene scene;
  EyeView view = viewOf(scene, EyeChoice::Mono);
  view.t_world_eye = TransformMatrix::translation(at);
  view.cyclopean->position = at;
  return view;
}

/// Pixels as they are in the picture's middle, for a thing `error` m large on the near side of a sphere.
double pixelsFor(double error, const Sphere& sphere, const EyeView& view) {
  const double distance = norm(sphere.centre - view.t_world_eye.origin()) - sphere.radius;
  const double across = view.width / (view.view.tan_left + view.view.tan_right);
  const double up = view.height / (view.view.tan_down + view.view.tan_up);
  return error / distance * std::max(across, up);
}

TEST_F(Detail, BothEyesChooseTheSameAndNoMoreThanIsAllowed) {
  SeenScene scene;
  const std::vector<LevelRange> levels{{1, 30, 0.001}, {2, 20, 0.004}, {3, 10, 0.016}};
  const IndexRange finest{0, 40, 7};
  std::size_t chosen[4] = {};
  for (int i = 0; i < 10'000; ++i) {
    poseAnyhow(scene);
    const EyeView left = viewOf(scene, EyeChoice::Left);
    const EyeView right = viewOf(scene, EyeChoice::Right);
    ASSERT_NE(norm(left.t_world_eye.origin() - right.t_world_eye.origin()), 0.0);
    const double detail_px = std::pow(10.0, between(-3.0, 0.3));
    const double smallest_px = between(0.0, 20.0);
    const DetailChoice of_left(*left.cyclopean, detail_px, smallest_px);
    const DetailChoice of_right(*right.cyclopean, detail_px, smallest_px);
    const Sphere sphere{within(30.0), between(0.0, 0.5)};
    const IndexRange range = coarsestWithin(of_left.allowedError(sphere), finest, levels);
    ASSERT_EQ(range, coarsestWithin(of_right.allowedError(sphere), finest, levels));
    ASSERT_EQ(of_left.tooSmall(sphere), of_right.tooSmall(sphere));
    ++chosen[range.first_index];
    const double error = range.first_index == 0 ? 0.0 : levels[range.first_index - 1].error;
    for (const EyeView& view : {left, right}) {
      ASSERT_TRUE(error == 0.0 || pixelsFor(error, sphere, view) <= detail_px);
      ASSERT_TRUE(!of_left.tooSmall(sphere) || pixelsFor(2.0 * sphere.radius, sphere, view) < smallest_px);
    }
  }
  for (const std::size_t times : chosen) EXPECT_GT(times, 100U) << "or nothing was chosen";
}

TEST_F(Detail, GrowsCoarserWithDistanceOnly) {
  const DetailChoice choice({{1.0, 2.0, 3.0}, 0.03, 400.0}, 0.25, 3.0);
  const Coord3 direction = normalized(Coord3{0.3, -0.4, 0.5});
  double last = 0.0;
  bool was_small = false;
  for (int step = 0; step < 1000; ++step) {
    const double distance = 0.1 * step;
    const Sphere sphere{Coord3{1.0, 2.0, 3.0} + distance * direction, 0.2};
    EXPECT_GE(choice.allowedError(sphere), last);
    last = choice.allowedError(sphere);
    EXPECT_EQ(last > 0.0, distance > 0.23) << "none in the sphere";
    EXPECT_GE(choice.tooSmall(sphere), was_small);
    was_small = choice.tooSmall(sphere);
  }
  EXPECT_NEAR(last, 0.25 * 99.67 / 400.0, 1e-4);
  EXPECT_TRUE(was_small);
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Sphere& odd : {Sphere{{nan, 0.0, 0.0}, 1.0}, Sphere{{}, nan}, Sphere{{}, inf}}) {
    EXPECT_FALSE(choice.allowedError(odd) > 0.0) << "the finest";
    EXPECT_FALSE(choice.tooSmall(odd));
  }
}

/// A hundred curved things of one colour, beside each other ahead of the eyes; every
/// second moves, one in three is mirrored.
void addThings(TestScene& scene, const Material& material = glow(1.0, 1.0, 1.0), int sides = 48) {
  for (int i = 0; i < 100; ++i) {
    const double away = 3.0 + 0.4 * i;
    const int row = i / 10;
    const Coord3 at{away * 0.08 * (i % 10 - 4.5), 1.2 + away * 0.06 * (row - 4.5), -away};
    const double radius = 0.02 * away;
    const auto place = [&](Polyhedron& thing) {
      if (i % 2 == 0) thing.attach(Moving{});
      thing.setTransform(TransformMatrix::translation(at) *
                         TransformMatrix::rotation({1.0, 0.3 * i, 0.5}, 0.4 * i) *
                         TransformMatrix::scaling({i % 3 == 0 ? -1.0 : 1.0, 1.0, 1.0}));
    };
    if (i % 4 < 2)
      place(scene.add<Cylinder>(at, material, radius, 2.0 * radius, sides));
    else
      place(scene.add<Ellipsoid>(at, material, Coord3{radius, 0.7 * radius, 1.3 * radius}, sides));
  }
}

struct Difference {
  double coverage = 0.0;  ///< by which pixels differ, summed, pixels
  double edge = 0.0;      ///< pixels that an edge goes through
  bool inside = false;    ///< whether one differs that has no edge in it or beside it
};

Difference difference(const Image& finest, const Image& other) {
  Difference found;
  for (int y = 1; y + 1 < finest.height; ++y)
    for (int x = 1; x + 1 < finest.width; ++x) {
      const int here = value(finest, x, y, Red);
      bool at_edge = false;
      for (int i = 0; i < 9; ++i)
        at_edge = at_edge || value(finest, x + i % 3 - 1, y + i / 3 - 1, Red) != here;
      found.edge += here > 0 && here < 255 ? 1.0 : 0.0;
      const int there = value(other, x, y, Red);
      found.coverage += std::abs(linear(here) - linear(there));
      found.inside = found.inside || (here != there && !at_edge);
    }
  return found;
}

TEST_F(Detail, MovesEdgesByNoMoreThanIsAllowedAndNothingElse) {
  TestScene scene;
  addThings(scene);
  const EyeView view = viewFrom({0.0, 1.2, 0.0});
  const RendererSettings finest{.samples = 4, .shadows = false, .detail_px = 0.0};
  Renderer fine(scene, scene.illumination(), kWidth, kHeight, finest);
  const Image expected = picture(fine, {&view, 1});
  std::size_t last = fine.counts().triangles;
  for (const double detail_px : {0.25, 1.0}) {
    RendererSettings settings = finest;
    settings.detail_px = detail_px;
    Renderer coarse(scene, scene.illumination(), kWidth, kHeight, settings);
    const Difference found = difference(expected, picture(coarse, {&view, 1}));
    EXPECT_LT(coarse.counts().triangles, last);
    last = coarse.counts().triangles;
    EXPECT_FALSE(found.inside) << detail_px;
    EXPECT_LT(found.coverage, detail_px * found.edge) << detail_px;
    EXPECT_GT(found.coverage, 0.0) << "or the levels are not drawn";
    RecordProperty("moved_by_at_" + std::to_string(detail_px), std::to_string(found.coverage / found.edge));
  }
}

TEST_F(Detail, ChangesLightLittle) {
  TestScene scene;
  scene.setAmbient({0.3, 0.3, 0.3}, {0.1, 0.1, 0.1});
  scene.addLight({{4.0, 20.0, 0.0}, {1.0, 1.0, 1.0}, 500.0, 200.0});
  addThings(scene, matt(0.7, 0.7, 0.7));
  const EyeView view = viewFrom({0.0, 1.2, 0.0});
  const auto draw = [&](double detail_px) {
    Renderer renderer(scene, scene.illumination(), kWidth, kHeight, {.detail_px = detail_px});
    return picture(renderer, {&view, 1});
  };
  const Image fine = draw(0.0);
  const Image coarse = draw(0.25);
  EXPECT_GT(shareDiffering(fine, coarse, 0), 0.0);
  for (const auto& [tolerance, share] : {std::pair{3, 0.02}, {30, 0.001}}) {
    const double differing = shareDiffering(fine, coarse, tolerance);
    EXPECT_LT(differing, share) << tolerance;
    RecordProperty("differing_by_more_than_" + std::to_string(tolerance), std::to_string(differing));
  }
}

TEST_F(Detail, NothingStandsInTheShadowOfItsOwnFinerForm) {
  TestScene scene;
  scene.setAmbient({0.6, 0.6, 0.6}, {0.2, 0.2, 0.2});
  scene.addMoving<Ellipsoid>({0.0, 0.6, -20.0}, matt(0.7, 0.7, 0.7), Coord3{1.2, 0.5, 1.2}, 16);
  EyeView view = viewFrom({0.0, 4.0, -10.0});
  view.t_world_eye = view.t_world_eye * TransformMatrix::rotationX(-0.3);
  view.view = {0.15, 0.15, 0.11, 0.11};
  view.t_world_vehicle = TransformMatrix::translation({0.0, 0.0, -19.3});
  const auto draw = [&](double detail_px) {
    Renderer renderer(scene, scene.illumination(), kWidth, kHeight, {.detail_px = detail_px});
    return picture(renderer, {&view, 1});
  };
  EXPECT_LT(shareDiffering(draw(0.0), draw(4.0), 20), 0.05);
}

TEST_F(Detail, SaysOfEachPixelWhoseItIsInACoarserFormToo) {
  TestScene scene;
  addThings(scene, glow(1.0, 1.0, 1.0), 12);  // few enough for several to share a block
  const EyeView view = viewFrom({0.0, 1.2, 0.0});
  const auto ids = [&](double detail_px) {
    Renderer renderer(scene, scene.illumination(), kWidth, kHeight, {.samples = 1, .detail_px = detail_px});
    return renderer.drawIds({&view, 1});
  };
  const IdImage fine = ids(0.0);
  const IdImage coarse = ids(1.0);
  ASSERT_EQ(fine.objects, coarse.objects);
  int differing = 0;
  for (int y = 1; y + 1 < kHeight; ++y)
    for (int x = 1; x + 1 < kWidth; ++x) {
      const auto id = [&](const IdImage& image, int dx, int dy) {
        return image.ids[static_cast<std::size_t>(y + dy) * kWidth + static_cast<std::size_t>(x + dx)];
      };
      if (id(fine, 0, 0) == id(coarse, 0, 0)) continue;
      bool beside = false;
      for (int i = 0; i < 9; ++i) beside = beside || id(fine, i % 3 - 1, i / 3 - 1) == id(coarse, 0, 0);
      EXPECT_TRUE(beside) << "another object's number at " << x << ", " << y;
      ++differing;
    }
  EXPECT_GT(differing, 0);
}

TEST_F(Detail, IsFullWithoutAPointToChooseItFromAndAtZero) {
  TestScene scene;
  addThings(scene);
  EyeView view = viewFrom({0.0, 1.2, 0.0});
  Renderer chosen(scene, scene.illumination(), kWidth, kHeight, {.samples = 1});
  Renderer zero(scene, scene.illumination(), kWidth, kHeight, {.samples = 1, .detail_px = 0.0});
  const Image at_zero = picture(zero, {&view, 1});
  picture(chosen, {&view, 1});
  EXPECT_LT(chosen.counts().triangles, zero.counts().triangles);
  view.cyclopean.reset();
  EXPECT_EQ(shareDiffering(picture(chosen, {&view, 1}), at_zero, 0), 0.0);
  EXPECT_EQ(chosen.counts().triangles, zero.counts().triangles);
}

TEST_F(Detail, LeavesOutWhatIsTooSmallAndNothingAtZero) {
  TestScene scene;
  scene.addMoving<Box>({0.0, 1.2, -20.0}, kRed, Coord3{0.2, 0.2, 0.2});
  scene.add<Box>({1.0, 1.2, -20.0}, kRed, Coord3{0.2, 0.2, 0.2});
  scene.addMoving<Box>({-1.0, 1.2, -5.0}, kGreen, Coord3{0.5, 0.5, 0.5});
  scene.add<Box>({-2.0, 1.2, -25.0}, kGreen, Coord3{2.0, 2.0, 2.0});
  const EyeView view = viewFrom({0.0, 1.2, 0.0});
  const auto draw = [&](double smallest_px) {
    Renderer renderer(scene, scene.illumination(), kWidth, kHeight,
                      {.samples = 4, .smallest_px = smallest_px});
    return picture(renderer, {&view, 1});
  };
  const Image all = draw(0.0);
  EXPECT_GT(spot(all, Red).light, 0.5);
  EXPECT_EQ(shareDiffering(draw(0.1), all, 0), 0.0);
  const Image large = draw(5.0);
  EXPECT_EQ(spot(large, Red).light, 0.0);
  EXPECT_EQ(spot(large, Green).light, spot(all, Green).light);
}

}  // namespace
}  // namespace coherency
