// Two eyes: never in one place, and every point of the world in their pictures where geometry puts it.

#include <array>
#include <cmath>
#include <filesystem>

#include "common/math/FixedPoint.h"
#include "render_client/draw/EyeViews.h"
#include "tests/render/Seated.h"

namespace coherency {
namespace {

const std::array<Seat, 2> kHeads = {
    Seat{{}, {}, {}},
    Seat{{0.1, 0.05, -0.1}, {0.5, -0.3, 0.2}, {1'500'000'000, 0, -2'000'000'000, 0x2000'0000}}};

TEST(EyeViews, EyesAreTheRigsEyeDistanceApartAndNeverInOnePlace) {
  for (const double eye_distance : {0.05, 0.064, 0.075})
    for (const Seat& head : kHeads) {
      Rig rig;
      rig.eye_distance = eye_distance;
      SeenScene scene(rig);
      sit(scene, head);
      std::vector<EyeView> both;
      std::vector<EyeView> one;
      eyeViews(scene, Mode::Operator, {}, EyeChoice::Both, 64, 48, both);
      ASSERT_EQ(both.size(), 2U);
      const Coord3 apart = both[1].t_world_eye.origin() - both[0].t_world_eye.origin();
      const Coord3 to_the_right = both[0].t_world_eye.vector({1.0, 0.0, 0.0});
      EXPECT_LT(norm(apart - eye_distance * to_the_right), 1e-12);
      EXPECT_TRUE(both[0].t_world_eye.linear() == both[1].t_world_eye.linear())
          << "optical axes are parallel";
      EXPECT_EQ(both[0].x, 0);
      EXPECT_EQ(both[1].x, 64);

      eyeViews(scene, Mode::Operator, {}, EyeChoice::Left, 64, 48, one);
      ASSERT_EQ(one.size(), 1U);
      EXPECT_TRUE(one[0].t_world_eye == both[0].t_world_eye);
      eyeViews(scene, Mode::Operator, {}, EyeChoice::Right, 64, 48, one);
      ASSERT_EQ(one.size(), 1U);
      EXPECT_TRUE(one[0].t_world_eye == both[1].t_world_eye);
      EXPECT_EQ(one[0].x, 0) << "alone on its own picture";
      eyeViews(scene, Mode::Operator, {}, EyeChoice::Mono, 64, 48, one);
      ASSERT_EQ(one.size(), 1U);
      EXPECT_LT(norm(one[0].t_world_eye.origin() - both[0].t_world_eye.origin() - 0.5 * apart), 1e-12);
    }
}

TEST(EyeViews, SayWhereTheOtherVehicleStandsWhereThereIsOne) {
  SceneDescription description;
  description.name = "test";
  description.start = basePose(1.0, 2.0, 0.5);
  std::vector<EyeView> views;
  const Scene alone(description, {});
  eyeViews(alone, Mode::Operator, {}, EyeChoice::Both, 64, 48, views);
  for (const EyeView& view : views) EXPECT_FALSE(view.t_world_other_vehicle.has_value());

  description.robot = RobotPlacement{basePose(-2.0, -1.0, 0.0), basePose(0.0, -2.0, 0.0)};
  Scene scene(description, {});
  sit(scene, {{}, {}, description.start});
  for (const Mode mode : {Mode::Operator, Mode::Robot}) {
    const VRObject& driven =
        mode == Mode::Robot ? static_cast<const VRObject&>(*scene.robot()) : scene.human();
    const VRObject& other =
        mode == Mode::Robot ? static_cast<const VRObject&>(scene.human()) : *scene.robot();
    eyeViews(scene, mode, {}, EyeChoice::Both, 64, 48, views);
    for (const EyeView& view : views) {
      EXPECT_TRUE(view.t_world_vehicle == driven.globalTransform());
      EXPECT_TRUE(view.t_world_other_vehicle == other.globalTransform());
    }
  }
}

TEST(EyeViews, TemplesSeeWiderThanTheNose) {
  SeenScene scene;
  std::vector<EyeView> views;
  eyeViews(scene, Mode::Operator, {}, EyeChoice::Both, 64, 48, views);
  EXPECT_GT(views[0].view.tan_left, views[0].view.tan_right);
  EXPECT_EQ(views[0].view.tan_left, views[1].view.tan_right);
  EXPECT_EQ(views[0].view.tan_right, views[1].view.tan_left);
}

TEST(EyeViews, PixelsAreSquareWhateverThePicturesShape) {
  SeenScene scene;
  std::vector<EyeView> views;
  for (const auto& [width, height] : {std::pair{640, 480}, {1280, 1440}, {100, 300}}) {
    eyeViews(scene, Mode::Operator, {}, EyeChoice::Both, width, height, views);
    for (const EyeView& eye : views)
      EXPECT_NEAR((eye.view.tan_left + eye.view.tan_right) / width,
                  (eye.view.tan_down + eye.view.tan_up) / height, 1e-12);
  }
}

/// As the published matrices of a headset with displays turned outwards by 5 degrees have it.
TEST(EyeViews, CantedEyesSeeADirectionOnTheRightPixel) {
  const HmdProfile hmd = readHmdProfile("index");
  SeenScene scene;
  sit(scene, kHeads[1]);
  std::vector<EyeView> views;
  eyeViews(scene, Mode::Operator, hmd, EyeChoice::Both, hmd.panel->width, hmd.panel->height, views);
  const double outwards[] = {0.087156, -0.087156};
  for (std::size_t e = 0; e < 2; ++e) {
    const TransformMatrix t_world_eye =
        scene.eye(e == 0 ? Eye::Left : Eye::Right, Mode::Operator).globalTransform();
    EXPECT_LT(norm(views[e].t_world_eye.origin() - t_world_eye.origin()), 1e-12)
        << "an eye turns about itself";
    const TransformMatrix t_head_display = TransformMatrix::fromAxes(
        {0.996195, 0.0, -outwards[e]}, {0.0, 1.0, 0.0}, {outwards[e], 0.0, 0.996195});
    for (const Coord3& ahead : {Coord3{0.0, 0.0, -1.0}, Coord3{0.4, 0.3, -1.0}, Coord3{-0.5, -0.6, -2.0}}) {
      const Coord3 p_display = t_head_display.linear().rigidInverse().vector(ahead);
      const PixelPoint expected =
          projectToPixels(views[e].view, p_display, hmd.panel->width, hmd.panel->height);
      const Coord3 p_eye = views[e].t_world_eye.rigidInverse().point(t_world_eye.point(ahead));
      const PixelPoint seen = projectToPixels(views[e].view, p_eye, hmd.panel->width, hmd.panel->height);
      EXPECT_NEAR(seen.x, expected.x, 0.01);
      EXPECT_NEAR(seen.y, expected.y, 0.01);
    }
  }
  const Coord3 straight_left = views[0].t_world_eye.rigidInverse().vector(
      scene.eye(Eye::Mono, Mode::Operator).globalTransform().vector({0.0, 0.0, -1.0}));
  EXPECT_GT(straight_left.x, 0.0) << "the left display is turned to the left";
}

TEST(EyeViews, EveryShippedDisplayHasTheRigsEyeDistance) {
  Rig rig;
  rig.eye_distance = 0.059;
  SeenScene scene(rig);
  sit(scene, kHeads[1]);
  std::vector<EyeView> views;
  for (const auto& entry : std::filesystem::directory_iterator(COHERENCY_CONFIGS "/hmds")) {
    const HmdProfile hmd = readHmdProfile(entry.path().string());
    eyeViews(scene, Mode::Operator, hmd, EyeChoice::Both, 640, 480, views);
    EXPECT_NEAR(norm(views[1].t_world_eye.origin() - views[0].t_world_eye.origin()), 0.059, 1e-9) << hmd.name;
  }
}

TEST(EyeViews, TextIsSeenByBothEyesInOnePlaceThroughLensesAndOnCantedDisplays) {
  SeenScene scene;
  std::vector<EyeView> views;
  for (const char* name : {"vive", "index", "rift_dk1"}) {
    const HmdProfile hmd = readHmdProfile(name);
    eyeViews(scene, Mode::Operator, hmd, EyeChoice::Both, 1200, 1200, views);
    for (const double along : {0.0, 0.5, 1.0}) {
      std::array<Coord3, 2> ahead;  // of between the eyes, where the lines of sight are 2 m away
      for (std::size_t e = 0; e < 2; ++e) {
        const EyeView& eye = views[e];
        const double x = (eye.text_x + along * eye.text_width) / 1200;
        const Coord3 sight{x * (eye.view.tan_left + eye.view.tan_right) - eye.view.tan_left,
                           eye.view.tan_up - eye.text_y / 1200 * (eye.view.tan_up + eye.view.tan_down), -1.0};
        ahead[e] = 2.0 * sight + Coord3{(e == 0 ? -0.5 : 0.5) * Rig{}.eye_distance, 0.0, 0.0};
        const EyeDisplay& display = e == 0 ? hmd.left : hmd.right;
        const Coord3 on_display = rotation(display.axis).rigidInverse().vector(sight);
        EXPECT_LT(norm(on_display - eye.t_eye_head.vector(sight)), 1e-12) << name;
        const PixelPoint at = projectToPixels(eye.view, on_display, 1200, 1200);
        EXPECT_TRUE(at.x > 0.0 && at.x < 1200.0 && at.y > 0.0 && at.y < 1200.0) << name << " has it";
        if (!display.lens) continue;
        const auto shown = display.lens->shown(1, {sight.x, sight.y});
        ASSERT_TRUE(shown) << name << " shows where text is";
        EXPECT_TRUE(shown->x > 0.0 && shown->x < hmd.panel->width && shown->y > 0.0) << name;
      }
      EXPECT_LT(norm(ahead[0] - ahead[1]), along == 0.0 ? 1e-9 : 1e-3) << name;
    }
  }
}

TEST(EyeViews, TextIsSeenByBothEyesInOnePlaceTwoMetresAhead) {
  SeenScene scene;
  std::vector<EyeView> views;
  for (const auto& [width, height] : {std::pair{640, 480}, {1280, 1440}}) {
    eyeViews(scene, Mode::Operator, {}, EyeChoice::Both, width, height, views);
    std::array<double, 2> tangent{};
    for (std::size_t e = 0; e < 2; ++e) {
      const EyeView& eye = views[e];
      const double pixels = width / (eye.view.tan_left + eye.view.tan_right);
      tangent[e] = eye.text_x / pixels - eye.view.tan_left;
      EXPECT_GT(eye.text_x, 0.0);
      EXPECT_GT(eye.text_width, 0.4 * width);
      EXPECT_LT(eye.text_x + eye.text_width, width);
    }
    EXPECT_NEAR(tangent[0] - tangent[1], Rig{}.eye_distance / 2.0, 1e-9);
    EXPECT_EQ(views[0].text_y, views[1].text_y);
    EXPECT_EQ(views[0].text_width, views[1].text_width);
  }
}

class Stereo : public DrawingTest {};

struct Marker {
  double distance;  ///< m ahead of the eyes' plane
  double right;     ///< tangents, as seen from between the eyes
  double up;
  Channel channel;
};
constexpr std::array<Marker, 3> kMarkers = {Marker{0.5, -0.05, -0.06, Red}, Marker{1.0, 0.13, 0.02, Green},
                                            Marker{5.0, 0.02, 0.2, Blue}};
constexpr double kAngularRadius = 0.012;

Coord3 position(const Marker& marker) {
  return marker.distance * Coord3{marker.right, marker.up, -1.0};
}

void addMarkers(SeenScene& scene) {
  const TransformMatrix t_world_head = scene.human().eye(Eye::Mono).globalTransform();
  for (const Marker& marker : kMarkers) {
    const double radius = kAngularRadius * marker.distance;
    const Material material = marker.channel == Red ? kRed : marker.channel == Green ? kGreen : kBlue;
    scene.add<Ellipsoid>(t_world_head.point(position(marker)), material, Coord3{radius, radius, radius}, 64);
  }
}

/// Where the marker is in both pictures against where it must be, and their difference against the textbook's
/// disparity.
void expectMarker(const Marker& marker, const std::vector<EyeView>& views, const Image& image) {
  const int width = views[0].width;
  const double half = 0.5 * Rig().eye_distance;
  std::array<double, 2> seen_x{};
  for (const int eye : {0, 1}) {
    const EyeView& view = views[static_cast<std::size_t>(eye)];
    const Coord3 p_eye = position(marker) + Coord3{eye == 0 ? half : -half, 0.0, 0.0};
    const PixelPoint expected = projectToPixels(view.view, p_eye, width, view.height);
    const Spot seen = spot(image, marker.channel, eye * width, (eye + 1) * width);
    seen_x[static_cast<std::size_t>(eye)] = seen.x - eye * width;
    EXPECT_NEAR(seen.x - eye * width, expected.x, 0.1) << "eye " << eye << " at " << marker.distance << " m";
    EXPECT_NEAR(seen.y, expected.y, 0.1) << "eye " << eye << " at " << marker.distance << " m";
  }
  // Parallel axes: base over distance in tangents, and the shift of the two asymmetric pictures' edges.
  const double degree = kTurn / 360.0;
  const double temple = std::tan(52.0 * degree);
  const double nose = std::tan(44.0 * degree);
  const double disparity = (0.064 / marker.distance + temple - nose) * width / (temple + nose);
  EXPECT_NEAR(seen_x[0] - seen_x[1], disparity, 0.1) << "disparity at " << marker.distance << " m";
}

void expectMarkersInBothEyes(const Seat& head, int width, int height) {
  SeenScene scene;
  sit(scene, head);
  addMarkers(scene);
  std::vector<EyeView> views;
  eyeViews(scene, Mode::Operator, {}, EyeChoice::Both, width, height, views);
  Renderer renderer(scene, scene.illumination(), 2 * width, height, {.samples = 4});
  ASSERT_EQ(renderer.samples(), 4);
  const Image image = picture(renderer, views);
  for (const Marker& marker : kMarkers) expectMarker(marker, views, image);
}

TEST_F(Stereo, MarkersAreWhereGeometryPutsThemAt640x480) {
  for (const Seat& head : kHeads) expectMarkersInBothEyes(head, 640, 480);
}

TEST_F(Stereo, MarkersAreWhereGeometryPutsThemAt1280x1440) {
  for (const Seat& head : kHeads) expectMarkersInBothEyes(head, 1280, 1440);
}

TEST_F(Stereo, AnEyeAloneSeesWhatItSeesBesideTheOther) {
  SeenScene scene;
  sit(scene, kHeads[1]);
  addMarkers(scene);
  scene.setAmbient({0.2, 0.3, 0.4}, {0.1, 0.1, 0.1});
  scene.addLight(
      {scene.human().eye(Eye::Mono).globalTransform().point({0.0, 1.0, 0.0}), {1.0, 1.0, 1.0}, 3.0});
  scene.add<Box>(scene.human().eye(Eye::Mono).globalTransform().point({0.1, 0.0, -0.6}), matt(0.8, 0.7, 0.6),
                 Coord3{0.1, 0.2, 0.1});
  constexpr int kWidth = 200;
  constexpr int kHeight = 150;
  const auto seenBy = [&](EyeChoice choice) {
    std::vector<EyeView> views;
    eyeViews(scene, Mode::Operator, {}, choice, kWidth, kHeight, views);
    Renderer renderer(scene, scene.illumination(), kWidth * eyeCount(choice), kHeight);
    return picture(renderer, views);
  };
  const Image both = seenBy(EyeChoice::Both);
  const Image left = seenBy(EyeChoice::Left);
  const Image right = seenBy(EyeChoice::Right);
  EXPECT_EQ(shareDiffering(columns(both, 0, kWidth), left, 0), 0.0);
  EXPECT_EQ(shareDiffering(columns(both, kWidth, 2 * kWidth), right, 0), 0.0);
  EXPECT_GT(shareDiffering(left, right, 8), 0.01) << "and the two are not the same picture";
}

TEST_F(Stereo, EdgesAreAveragedInLinearLight) {
  SeenScene scene;
  addMarkers(scene);
  std::vector<EyeView> views;
  eyeViews(scene, Mode::Operator, {}, EyeChoice::Mono, 640, 480, views);
  Renderer renderer(scene, scene.illumination(), 640, 480, {.samples = 4});
  const Image image = picture(renderer, views);
  int most = 0;
  for (std::size_t i = Red; i < image.rgb.size(); i += 3) most = std::max<int>(most, image.rgb[i]);
  std::array<int, 5> found{};
  for (std::size_t i = Red; i < image.rgb.size(); i += 3) {
    const double quarters = 4.0 * linear(image.rgb[i]) / linear(most);
    ASSERT_NEAR(quarters, std::round(quarters), 0.05) << "four samples make quarters";
    ++found[static_cast<std::size_t>(std::lround(quarters))];
  }
  for (const int count : found) EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace coherency
