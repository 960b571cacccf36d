// What a panel shows, seen through its lens, is the picture that was drawn: by the mesh's own figures, and in
// what is drawn with it.

#include <array>
#include <cmath>
#include <deque>
#include <filesystem>
#include <numeric>
#include <optional>

#include "render_client/draw/DistortionMesh.h"
#include "render_client/draw/PictureSize.h"
#include "tests/render/Support.h"

namespace coherency {
namespace {

std::vector<HmdProfile> shippedLenses() {
  std::vector<HmdProfile> found;
  for (const auto& entry : std::filesystem::directory_iterator(COHERENCY_CONFIGS "/hmds"))
    if (HmdProfile hmd = readHmdProfile(entry.path().string()); hasLens(hmd, EyeChoice::Both))
      found.push_back(std::move(hmd));
  return found;
}

PanelSize pictureOf(const HmdProfile& hmd, double scale = 1.0) {
  return pictureSize(hmd, EyeChoice::Both, hmd.panel->width, hmd.panel->height, scale);
}

double offCentre(const Lens& lens, const PixelPoint& p) {
  return std::hypot(p.x - lens.centre_x, p.y - lens.centre_y) / lens.unit_px;
}

PixelPoint pixel(const DistortionVertex::Point& of_one, const PanelSize& size) {
  return {static_cast<double>(of_one[0]) * size.width, (1.0 - static_cast<double>(of_one[1])) * size.height};
}

double turn(const PixelPoint& a, const PixelPoint& b, const PixelPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The farthest that a mesh's triangles, interpolated as a GPU does, are off the lens's curves at pixels of
/// the panel that the lens shows, in pixels of the picture; and how many pixels those are.
struct MeshError {
  double worst_px = 0.0;
  int pixels = 0;
};

MeshError errorOf(const DistortionMesh& mesh, const EyeDisplay& eye, const PanelSize& panel,
                  const PanelSize& picture) {
  MeshError error;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    std::array<const DistortionVertex*, 3> corners{};
    std::array<PixelPoint, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = &mesh.vertices.at(mesh.indices.at(t + i));
      at[i] = pixel(corners[i]->panel, panel);
    }
    const double area = turn(at[0], at[1], at[2]);
    const auto [left, right] = std::minmax({at[0].x, at[1].x, at[2].x});
    const auto [top, bottom] = std::minmax({at[0].y, at[1].y, at[2].y});
    for (double y = std::floor(std::max(top, 0.0)) + 0.5; y < std::min(bottom, panel.height + 0.0); ++y)
      for (double x = std::floor(std::max(left, 0.0)) + 0.5; x < std::min(right, panel.width + 0.0); ++x) {
        const PixelPoint p{x, y};
        const std::array<double, 3> share = {turn(at[1], at[2], p) / area, turn(at[2], at[0], p) / area,
                                             turn(at[0], at[1], p) / area};
        if (std::min({share[0], share[1], share[2]}) < 0.0) continue;
        ++error.pixels;
        for (std::size_t colour = 0; colour < 3; ++colour) {
          PixelPoint taken;
          for (std::size_t i = 0; i < 3; ++i) {
            const PixelPoint corner = pixel(corners[i]->picture[colour], picture);
            taken.x += share[i] * corner.x;
            taken.y += share[i] * corner.y;
          }
          const Direction seen = eye.lens->seen(colour, p);
          const PixelPoint wanted =
              projectToPixels(eye.view, {seen.right, seen.up, -1.0}, picture.width, picture.height);
          error.worst_px = std::max(error.worst_px, std::hypot(taken.x - wanted.x, taken.y - wanted.y));
        }
      }
  }
  return error;
}

int pixelsShown(const Lens& lens, const PanelSize& panel) {
  int count = 0;
  for (int y = 0; y < panel.height; ++y)
    for (int x = 0; x < panel.width; ++x) count += offCentre(lens, {x + 0.5, y + 0.5}) < lens.radius ? 1 : 0;
  return count;
}

TEST(Distortion, TheMeshIsWithinATenthOfAPixelOfTheCurvesOfEveryShippedLens) {
  const std::vector<HmdProfile> lenses = shippedLenses();
  EXPECT_GE(lenses.size(), 3U);
  for (const HmdProfile& hmd : lenses)
    for (const EyeDisplay* eye : {&hmd.left, &hmd.right}) {
      const PanelSize picture = pictureOf(hmd);
      const DistortionMesh mesh = distortionMesh(*eye, *hmd.panel, picture);
      const MeshError error = errorOf(mesh, *eye, *hmd.panel, picture);
      EXPECT_LT(error.worst_px, kDistortionErrorPx) << hmd.name;
      EXPECT_NEAR(error.pixels, pixelsShown(*eye->lens, *hmd.panel), 2e-3 * error.pixels)
          << hmd.name << ": all that the lens shows, and each pixel once";
      std::printf("%s: %d rings, %d spokes, off by %.3f px at most\n", hmd.name.c_str(), mesh.rings,
                  mesh.spokes, error.worst_px);
    }
}

TEST(Distortion, MeshesAreAsFineAsTheErrorAskedForAndRefusedBeyond) {
  const HmdProfile hmd = readHmdProfile("rift_dk1");
  const PanelSize picture = pictureOf(hmd);
  std::size_t triangles = 0;
  for (const double error_px : {4.0, 1.0, 0.25, 0.05}) {
    const DistortionMesh mesh = distortionMesh(hmd.left, *hmd.panel, picture, error_px);
    EXPECT_LT(errorOf(mesh, hmd.left, *hmd.panel, picture).worst_px, error_px);
    EXPECT_GT(mesh.indices.size(), triangles);
    triangles = mesh.indices.size();
  }
  EXPECT_THROW(distortionMesh(hmd.left, *hmd.panel, picture, 1e-7), std::runtime_error);
}

TEST(Distortion, ALensesPictureHasAPanelPixelForEachInItsMiddle) {
  for (const HmdProfile& hmd : shippedLenses()) {
    const PanelSize picture = pictureOf(hmd);
    const PixelPoint centre{hmd.left.lens->centre_x, hmd.left.lens->centre_y};
    const Direction a = hmd.left.lens->seen(1, {centre.x - 0.5, centre.y});
    const Direction b = hmd.left.lens->seen(1, {centre.x + 0.5, centre.y});
    const double pixels =
        (b.right - a.right) * picture.width / (hmd.left.view.tan_left + hmd.left.view.tan_right);
    EXPECT_NEAR(pixels, 1.0, 0.03) << hmd.name;
    const PanelSize half = pictureOf(hmd, 0.5);
    EXPECT_NEAR(half.width, picture.width / 2.0, 1.0);
    EXPECT_NEAR(half.height, picture.height / 2.0, 1.0);
  }
}

TEST(Distortion, APanelFitsInWhatThereIsAndStaysInShape) {
  const PanelPlace same = placePanel({1080, 1200}, 1080, 1200);
  EXPECT_EQ(std::pair(same.x, same.y), std::pair(0, 0));
  EXPECT_EQ(std::pair(same.width, same.height), std::pair(1080, 1200));
  const PanelPlace wide = placePanel({1080, 1200}, 2000, 600);
  EXPECT_EQ(std::pair(wide.width, wide.height), std::pair(540, 600));
  EXPECT_EQ(wide.x, 730);
  const PanelPlace high = placePanel({1080, 1200}, 540, 1000);
  EXPECT_EQ(std::pair(high.width, high.height), std::pair(540, 600));
  EXPECT_EQ(high.y, 200);
}

class DistortionPicture : public DrawingTest {};

/// A straight edge in space: what is lit has right * cos + up * sin < offset, in tangents from the eye.
struct Edge {
  double angle;
  double offset;
  double beyond(const Direction& d) const {
    return d.right * std::cos(angle) + d.up * std::sin(angle) - offset;
  }
};

void addHalf(TestScene& scene, const Edge& edge) {
  constexpr double kFar = 10.0;
  constexpr double kLarge = 1000.0;
  const double middle = edge.offset * kFar - 0.5 * kLarge;
  scene
      .add<Rectangle>({middle * std::cos(edge.angle), middle * std::sin(edge.angle), -kFar},
                      glow(1.0, 1.0, 1.0), kLarge, kLarge)
      .setOrientation(TransformMatrix::rotationZ(edge.angle));
}

EyeView viewThrough(const EyeDisplay& eye, const PanelSize& picture) {
  EyeView view = lookingAhead({0.0, 1.5, 0.0}, picture.width, picture.height);
  view.view = eye.view;
  view.t_world_eye = TransformMatrix{};
  return view;
}

/// An edge on a panel: its lines of pixels are rows where it is upright, else columns, and run from where it
/// is lit to where it is dark.
class EdgeOnPanel {
 public:
  static constexpr int kAround = 12;  ///< pixels of a line about the edge that are looked at

  EdgeOnPanel(const Lens& lens, const PanelSize& panel, const Edge& edge)
      : lens_(lens), panel_(panel), edge_(edge), upright_(std::abs(std::cos(edge.angle)) > 0.7) {}

  int lines() const { return upright_ ? panel_.height : panel_.width; }
  /// Pixels along a line to where the lens's curve needs the edge, so that it is seen straight; found by
  /// halving.
  std::optional<double> needed(Channel channel, int line) const {
    double low = kAround;
    double high = (upright_ ? panel_.width : panel_.height) - kAround;
    const auto dark = [&](double along) { return edge_.beyond(lens_.seen(channel, at(line, along))) > 0.0; };
    if (dark(low) || !dark(high)) return std::nullopt;
    for (int i = 0; i < 60; ++i) (dark(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    const bool inside = offCentre(lens_, at(line, low)) < lens_.radius - 2.0 * kAround / lens_.unit_px;
    return inside ? std::optional(low) : std::nullopt;
  }
  /// To where it is in a picture, by the light that there is about it.
  double found(const Image& image, Channel channel, int line, double near) const {
    const double first = std::floor(near) - kAround;
    const auto light = [&](int i) {
      const PixelPoint p = at(line, first + i + 0.5);
      return linear(value(image, static_cast<int>(p.x), static_cast<int>(p.y), channel));
    };
    double lit = 0.0;
    for (int i = 0; i < 2 * kAround; ++i) lit += light(i) / light(0);
    return first + lit;
  }

 private:
  PixelPoint at(int line, double along) const {
    return upright_ ? PixelPoint{along, line + 0.5} : PixelPoint{line + 0.5, panel_.height - along};
  }

  const Lens& lens_;
  PanelSize panel_;
  Edge edge_;
  bool upright_;
};

/// In panel pixels.
struct Off {
  double worst = 0.0;  ///< of the means of kTogether lines side by side
  double mean = 0.0;   ///< of all
};
/// With four samples a pixel, a single line says only to an eighth of a pixel where an edge is.
constexpr int kTogether = 4;

Off off(const Image& image, const EdgeOnPanel& edge) {
  Off result;
  int count = 0;
  for (const Channel channel : {Red, Green, Blue}) {
    std::deque<double> together;
    for (int line = 0; line < edge.lines(); ++line) {
      const auto needed = edge.needed(channel, line);
      if (!needed) continue;
      together.push_back(edge.found(image, channel, line, *needed) - *needed);
      result.mean += together.back();
      ++count;
      if (together.size() > kTogether) together.pop_front();
      if (together.size() == kTogether)
        result.worst = std::max(result.worst,
                                std::abs(std::accumulate(together.begin(), together.end(), 0.0)) / kTogether);
    }
  }
  EXPECT_GT(count, 600);
  result.mean /= count;
  return result;
}

Image panelWith(const HmdProfile& hmd, const EyeDisplay& eye, const Edge& edge) {
  TestScene scene;
  addHalf(scene, edge);
  const PanelSize picture = pictureOf(hmd);
  const EyeView view = viewThrough(eye, picture);
  Renderer renderer(scene, scene.illumination(), picture.width, picture.height);
  renderer.setDisplay(hmd, &eye == &hmd.left ? EyeChoice::Left : EyeChoice::Right);
  renderer.draw({&view, 1});
  return renderer.readPanel(hmd.panel->width, hmd.panel->height);
}

TEST_F(DistortionPicture, AStraightEdgeIsSeenStraightThroughTheLens) {
  // None along the pixels of the picture: its samples would all be off to one side.
  const std::array<Edge, 3> edges = {Edge{0.05, 0.55}, Edge{0.03, -0.31}, Edge{1.62, -0.62}};
  for (const HmdProfile& hmd : shippedLenses())
    for (const EyeDisplay* eye : {&hmd.left, &hmd.right})
      for (const Edge& edge : edges) {
        const Off found = off(panelWith(hmd, *eye, edge), {*eye->lens, *hmd.panel, edge});
        EXPECT_LT(found.worst, 0.25) << hmd.name << ", angle " << edge.angle;
        EXPECT_LT(std::abs(found.mean), 0.04) << hmd.name << ", angle " << edge.angle;
        std::printf("%s, edge at %.2f rad: off by %.3f panel px at most, %+.3f in the mean\n",
                    hmd.name.c_str(), edge.angle, found.worst, found.mean);
      }
}

TEST_F(DistortionPicture, ThePanelIsBlackBeyondTheLensAndLitWithin) {
  const HmdProfile hmd = readHmdProfile("vive");
  TestScene scene;
  scene.add<Rectangle>({0.0, 0.0, -1.0}, kGreen, 100.0, 100.0);
  const PanelSize picture = pictureOf(hmd);
  const EyeView view = viewThrough(hmd.left, picture);
  Renderer renderer(scene, scene.illumination(), picture.width, picture.height);
  renderer.setDisplay(hmd, EyeChoice::Left);
  renderer.draw({&view, 1});
  const Image panel = renderer.readPanel(hmd.panel->width, hmd.panel->height);
  for (int y = 0; y < panel.height; ++y)
    for (int x = 0; x < panel.width; ++x) {
      const double r = offCentre(*hmd.left.lens, {x + 0.5, y + 0.5}) / hmd.left.lens->radius;
      if (std::abs(r - 1.0) < 0.002) continue;
      ASSERT_EQ(value(panel, x, y, Green) > 0, r < 1.0) << x << ", " << y;
    }
}

TEST_F(DistortionPicture, AnEvenPictureKeepsItsColour) {
  const HmdProfile hmd = readHmdProfile("rift_dk2");
  TestScene scene;
  scene.add<Rectangle>({0.0, 0.0, -1.0}, glow(0.6, 0.2, 0.05), 100.0, 100.0);
  const PanelSize picture = pictureOf(hmd, 0.25);
  const EyeView view = viewThrough(hmd.left, picture);
  Renderer renderer(scene, scene.illumination(), picture.width, picture.height);
  renderer.setDisplay(hmd, EyeChoice::Left, 0.25);
  renderer.draw({&view, 1});
  const Image seen = renderer.readImage();
  const Image panel = renderer.readPanel(hmd.panel->width, hmd.panel->height);
  for (const Channel channel : {Red, Green, Blue})
    for (const int x : {100, 480, 860})
      EXPECT_EQ(value(panel, x, 540, channel), value(seen, picture.width / 2, picture.height / 2, channel));
}

TEST_F(DistortionPicture, NoEyeSeesAnythingOfTheOthersPicture) {
  const HmdProfile hmd = readHmdProfile("rift_dk1");
  TestScene scene;
  scene.add<Rectangle>({0.0, 0.0, -1.0}, kRed, 100.0, 100.0);
  scene.add<Rectangle>({0.0, 0.0, 1.0}, kBlue, 100.0, 100.0).setOrientation(TransformMatrix::rotationY(M_PI));
  const PanelSize picture = pictureOf(hmd);
  std::array<EyeView, 2> views{viewThrough(hmd.left, picture), viewThrough(hmd.right, picture)};
  views[1].x = picture.width;
  views[1].t_world_eye = TransformMatrix::rotationY(M_PI);
  Renderer renderer(scene, scene.illumination(), 2 * picture.width, picture.height);
  renderer.setDisplay(hmd, EyeChoice::Both);
  renderer.draw(views);
  const Image panels = renderer.readPanel(2 * hmd.panel->width, hmd.panel->height);
  EXPECT_EQ(spot(columns(panels, 0, hmd.panel->width), Blue).light, 0.0);
  EXPECT_GT(spot(columns(panels, 0, hmd.panel->width), Red).light, 1000.0);
  EXPECT_EQ(spot(columns(panels, hmd.panel->width, panels.width), Red).light, 0.0);
  EXPECT_GT(spot(columns(panels, hmd.panel->width, panels.width), Blue).light, 1000.0);
}

TEST_F(DistortionPicture, WithoutALensThePanelIsThePicture) {
  TestScene scene;
  addHalf(scene, {0.3, 0.1});
  const EyeView view = lookingAhead({}, 160, 120);
  Renderer renderer(scene, scene.illumination(), 160, 120);
  renderer.setDisplay(readHmdProfile("generic"), EyeChoice::Left);
  const Image seen = picture(renderer, {&view, 1});
  EXPECT_EQ(renderer.readPanel(160, 120).rgb, seen.rgb);
  renderer.setDisplay(readHmdProfile("vive"), EyeChoice::Mono);
  EXPECT_EQ(renderer.readPanel(160, 120).rgb, seen.rgb) << "the view from between the eyes has none";
}

}  // namespace
}  // namespace coherency
