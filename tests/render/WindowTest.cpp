// The same code draws the same picture in a window. Needs an X server, which ctest starts (CMakeLists.txt).

#include <cstdlib>
#include <fstream>

#include <epoxy/gl.h>

#include "render_client/draw/EyeViews.h"
#include "render_client/draw/PictureSize.h"
#include "tests/render/Support.h"

namespace coherency {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

void addBoxes(SeenScene& scene) {
  scene.setAmbient({0.3, 0.3, 0.4}, {0.1, 0.1, 0.1});
  scene.addLight({{0.5, 2.0, -1.0}, {1.0, 1.0, 1.0}, 3.0});
  scene.add<Box>({0.0, -0.6, -2.0}, matt(0.7, 0.7, 0.7), Coord3{4.0, 0.1, 4.0});
  scene.add<Box>({-0.4, 0.1, -2.0}, matt(0.8, 0.3, 0.2), Coord3{0.5, 0.5, 0.5});
  scene.add<Ellipsoid>({0.5, -0.2, -1.8}, Material{{0.3, 0.4, 0.8}, 0.5, 0.0}, Coord3{0.3, 0.3, 0.3});
}

/// Framebuffer 0, rows from the top.
Image readWindow(int width, int height) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height) * 3)};
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadBuffer(GL_BACK);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  const auto row = static_cast<std::size_t>(width) * 3;
  for (int y = 0; y < height; ++y)
    glReadPixels(0, height - 1 - y, width, 1, GL_RGB, GL_UNSIGNED_BYTE,
                 image.rgb.data() + static_cast<std::size_t>(y) * row);
  return image;
}

/// Top left corner of the X server's screen, where a window without a window manager lies. Xvfb keeps its
/// screen in a file as xwd writes it: big-endian words, then colours of 12 bytes, then pixels as blue, green,
/// red, unused.
Image readScreen(const char* file, int width, int height) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(bytes.at(at)); };
  const auto word = [&](std::size_t i) {
    return byte(4 * i) << 24 | byte(4 * i + 1) << 16 | byte(4 * i + 2) << 8 | byte(4 * i + 3);
  };
  constexpr std::size_t kHeaderSize = 0, kBitsPerPixel = 11, kBytesPerLine = 12, kColours = 19;
  EXPECT_EQ(word(kBitsPerPixel), 32);
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int channel : {2, 1, 0})
        image.rgb.push_back(byte(static_cast<std::size_t>(word(kHeaderSize) + 12 * word(kColours) +
                                                          y * word(kBytesPerLine) + 4 * x + channel)));
  return image;
}

TEST(Window, ShowsThePictureThatHeadlessDraws) {
  ASSERT_TRUE(anyEglDisplay());
  SeenScene scene;
  addBoxes(scene);
  const EyeView view = lookingAhead({}, kWidth, kHeight);
  DisplayConfig config;
  config.width = kWidth;
  config.height = kHeight;
  config.vsync = false;
  Image expected;
  {
    const auto headless = makeHeadlessDisplay(config);
    EXPECT_FALSE(headless->hasWindow());
    expected = picture(scene, view);
  }
  const auto window = makeWindowDisplay(config);
  EXPECT_TRUE(window->hasWindow());
  ASSERT_EQ(window->width(), kWidth);
  ASSERT_EQ(window->height(), kHeight);
  Renderer renderer(scene, scene.illumination(), kWidth, kHeight);
  const char* screen = std::getenv("COHERENCY_SCREEN");
  ASSERT_NE(screen, nullptr) << "must name Xvfb's screen file";
  double differing = 1.0;
  for (int frame = 0; frame < 200 && differing > 0.001;
       ++frame) {  // the server shows a frame when it comes to it
    EXPECT_FALSE(window->poll().close);
    renderer.draw({&view, 1});
    renderer.present(kWidth, kHeight);
    EXPECT_LE(shareDiffering(readWindow(kWidth, kHeight), expected, 2), 0.001) << "before it is shown";
    window->present();
    ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << "in frame " << frame;
    differing = shareDiffering(readScreen(screen, kWidth, kHeight), expected, 2);
  }
  EXPECT_LE(differing, 0.001) << "on the screen";
}

TEST(Window, ShowsWhatThePanelsMustForTheirLenses) {
  const HmdProfile hmd = readHmdProfile("rift_dk1");
  SeenScene scene;
  addBoxes(scene);
  DisplayConfig config;
  config.width = 2 * kWidth;
  config.height = kHeight;
  const auto window = makeWindowDisplay(config);
  const PanelSize picture = pictureSize(hmd, EyeChoice::Both, kWidth, kHeight, 1.0);
  std::vector<EyeView> views;
  eyeViews(scene, Mode::Operator, hmd, EyeChoice::Both, picture.width, picture.height, views);
  Renderer renderer(scene, scene.illumination(), 2 * picture.width, picture.height);
  renderer.setDisplay(hmd, EyeChoice::Both);
  for (const int width : {2 * kWidth, kWidth}) {  // as when a window was made narrower
    renderer.draw(views);
    const Image panels = renderer.readPanel(width, kHeight);
    renderer.present(width, kHeight);
    EXPECT_EQ(readWindow(width, kHeight).rgb, panels.rgb);
    EXPECT_GT(spot(panels, Green).light, 100.0);
  }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(Window, NarrowerThanTwoEyesStillHasAPixelForEach) {
  SeenScene scene;
  DisplayConfig config;
  config.width = 1;
  config.height = 1;
  const auto window = makeWindowDisplay(config);
  ASSERT_GE(window->width(), 2);
  std::vector<EyeView> views;
  eyeViews(scene, Mode::Operator, {}, EyeChoice::Both, window->width() / 2, window->height(), views);
  Renderer renderer(scene, scene.illumination(), window->width(), window->height());
  renderer.draw(views);
  renderer.present(window->width(), window->height());
  window->present();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace coherency
