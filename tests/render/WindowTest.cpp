// The same code draws the same picture in a window. Needs an X server, which ctest starts (CMakeLists.txt).

#include <epoxy/gl.h>

#include "tests/render/Support.h"

namespace coherency {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

void addBoxes(TestScene& scene) {
  scene.setAmbient({0.3, 0.3, 0.4}, {0.1, 0.1, 0.1});
  scene.addLight({{0.5, 2.0, -1.0}, {1.0, 1.0, 1.0}, 3.0});
  scene.add<Box>({0.0, -0.6, -2.0}, matt(0.7, 0.7, 0.7), Coord3{4.0, 0.1, 4.0});
  scene.add<Box>({-0.4, 0.1, -2.0}, matt(0.8, 0.3, 0.2), Coord3{0.5, 0.5, 0.5});
  scene.add<Ellipsoid>({0.5, -0.2, -1.8}, Material{{0.3, 0.4, 0.8}, 0.5, 0.0}, Coord3{0.3, 0.3, 0.3});
}

/// What is on the screen, rows from the top.
Image readWindow(GLenum buffer, int width, int height) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height) * 3)};
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadBuffer(buffer);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  const auto row = static_cast<std::size_t>(width) * 3;
  for (int y = 0; y < height; ++y)
    glReadPixels(0, height - 1 - y, width, 1, GL_RGB, GL_UNSIGNED_BYTE,
                 image.rgb.data() + static_cast<std::size_t>(y) * row);
  return image;
}

TEST(Window, ShowsThePictureThatHeadlessDraws) {
  ASSERT_TRUE(anyEglDisplay());
  TestScene scene;
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
  Renderer renderer(scene, kWidth, kHeight);
  for (int frame = 0; frame < 20; ++frame) {
    EXPECT_FALSE(window->poll().close);
    renderer.draw({&view, 1});
    renderer.present(kWidth, kHeight);
    if (frame == 19) {
      EXPECT_LE(shareDiffering(readWindow(GL_BACK, kWidth, kHeight), expected, 2), 0.001)
          << "before it is shown";
    }
    window->present();
    ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << "in frame " << frame;
  }
  EXPECT_LE(shareDiffering(readWindow(GL_FRONT, kWidth, kHeight), expected, 2), 0.001) << "on the screen";
  EXPECT_LE(shareDiffering(renderer.readImage(), expected, 2), 0.001) << "as a snapshot";
}

}  // namespace
}  // namespace coherency
