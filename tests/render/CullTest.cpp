// What is in view; needs no OpenGL.

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "common/math/Rotation.h"
#include "render_client/cull/SphereTree.h"
#include "tests/render/Chance.h"

namespace coherency {
namespace {

struct RandomView {
  TransformMatrix t_world_eye;
  FieldOfView view;
  double near_m;

  RandomView(Chance& chance, double size) : near_m(std::pow(10.0, chance.between(-5.0, 0.0))) {
    t_world_eye = TransformMatrix::translation(chance.in(size)) *
                  TransformMatrix::rotation(chance.direction(), chance.between(0.0, 6.0));
    // Angles of 0.05 to 89.9 degrees a side, and views to whose side the axis lies.
    const auto side = [&] { return std::tan(std::pow(10.0, chance.between(-1.3, 1.95)) * 0.0174533); };
    view = {side(), side(), side(), side()};
    if (chance.between(0.0, 1.0) < 0.2) view.tan_left = -0.5 * view.tan_right;
  }
  ViewPyramid pyramid() const { return {t_world_eye, view, near_m}; }
  bool shows(const Coord3& point) const {
    const Coord3 p = t_world_eye.rigidInverse().point(point);
    const double ahead = -p.z;
    return ahead >= near_m && p.x >= -view.tan_left * ahead && p.x <= view.tan_right * ahead &&
           p.y >= -view.tan_down * ahead && p.y <= view.tan_up * ahead;
  }
};

TEST(ViewPyramid, NeverSaysNoneOfWhatShowsNorAllOfWhatDoesNot) {
  Chance chance(1);
  int none = 0;
  int all = 0;
  for (int scene = 0; scene < 10'000; ++scene) {
    const RandomView view(chance, 10.0);
    const Sphere sphere{chance.in(20.0), std::pow(10.0, chance.between(-3.0, 1.5))};
    const InView in_view = view.pyramid().sees(sphere);
    none += in_view == InView::None ? 1 : 0;
    all += in_view == InView::All ? 1 : 0;
    for (int i = 0; i < 40; ++i) {
      const Coord3 point =
          sphere.centre + sphere.radius * std::sqrt(chance.between(0.0, 1.0)) * chance.direction();
      if (view.shows(point))
        ASSERT_NE(in_view, InView::None) << scene;
      else
        ASSERT_NE(in_view, InView::All) << scene;
    }
  }
  EXPECT_GT(none, 5000) << "or it is of no use";
  EXPECT_GT(all, 30);
}

TEST(ViewPyramid, KeepsWhatIsAroundTheEyeAndWhatIsNotFinite) {
  const ViewPyramid ahead({}, fieldOfViewFromDegrees(0.1, 0.1, 0.1, 0.1), 0.01);
  EXPECT_EQ(ahead.sees({{0.0, 0.0, 0.3}, 0.5}), InView::Part);
  EXPECT_EQ(ahead.sees({{0.0, 0.0, 0.3}, 0.2}), InView::None) << "behind";
  EXPECT_EQ(ahead.sees({{0.0, 0.0, -1e9}, 1.0}), InView::All) << "nothing is too far";
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const Sphere& odd : {Sphere{{}, kInfinite}, Sphere{{kInfinite, 0.0, 0.0}, 1.0},
                            Sphere{{0.0, kNan, 0.0}, 1.0}, Sphere{{0.0, 0.0, 5.0}, kNan}})
    EXPECT_EQ(ahead.sees(odd), InView::Part);
}

TEST(SphereTree, FindsExactlyWhatAskingOneByOneFinds) {
  Chance chance(2);
  for (int scene = 0; scene < 2000; ++scene) {
    std::vector<Sphere> things(static_cast<std::size_t>(chance.between(0.0, 60.0)));
    const double size = std::pow(10.0, chance.between(-2.0, 4.0));
    for (Sphere& thing : things) thing = {chance.in(size), size * std::pow(10.0, chance.between(-4.0, 0.0))};
    if (scene % 5 == 0 && !things.empty()) things.front().radius = std::numeric_limits<double>::infinity();
    const SphereTree tree(things);
    ViewPyramids view;
    for (int views = 1 + scene % 3; views > 0; --views) view.add(RandomView(chance, size).pyramid());
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < things.size(); ++i)
      if (view.sees(things[i]) != InView::None) expected.push_back(i);
    std::vector<std::uint32_t> seen;
    tree.findSeen(view, seen);
    std::sort(seen.begin(), seen.end());
    ASSERT_EQ(seen, expected) << scene;
  }
}

TEST(SphereTree, HoldsThingsThatAllStandInOnePlace) {
  const SphereTree tree(std::vector<Sphere>(1000, Sphere{{0.0, 0.0, -5.0}, 1.0}));
  std::vector<std::uint32_t> seen;
  ViewPyramids views;
  views.add(ViewPyramid({}, FieldOfView{}, 0.01));
  tree.findSeen(views, seen);
  EXPECT_EQ(seen.size(), 1000U);
  seen.clear();
  tree.findSeen({}, seen);
  EXPECT_EQ(seen.size(), 1000U) << "without a view nothing is clipped";
}

}  // namespace
}  // namespace coherency
