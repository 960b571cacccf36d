// The renderer as an object: its limits, its errors, sizes that change, text, and OpenGL left without
// complaint.

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <epoxy/gl.h>
#include <unistd.h>

#include "tests/render/Support.h"

namespace coherency {
namespace {

class RendererTest : public DrawingTest {};

constexpr int kWidth = 160;
constexpr int kHeight = 120;

/// What `act` throws, in words; "" where it throws nothing.
template <class Act>
std::string complaint(Act&& act) {
  try {
    act();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void addLitBoxes(TestScene& scene) {
  scene.setAmbient({0.3, 0.3, 0.3}, {0.1, 0.1, 0.1});
  scene.addLight({{0.0, 2.0, -1.0}, {1.0, 1.0, 1.0}, 3.0});
  scene.add<Box>({0.0, -0.6, -2.0}, matt(0.7, 0.7, 0.7), Coord3{4.0, 0.1, 4.0});
  scene.add<Box>({-0.4, 0.0, -2.0}, matt(0.8, 0.3, 0.2), Coord3{0.5, 0.5, 0.5})
      .setOrientation(TransformMatrix::scaling({-1.0, 1.0, 1.0}));
  scene.add<Ellipsoid>({0.5, 0.0, -1.8}, Material{{0.3, 0.4, 0.8}, 0.5, 0.0}, Coord3{0.3, 0.3, 0.3});
}

TEST_F(RendererTest, LeavesNoErrorInOpenGlOverAHundredFrames) {
  TestScene scene;
  addLitBoxes(scene);
  Renderer renderer(scene, scene.illumination(), 2 * kWidth, kHeight);
  ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << "after construction";
  for (int frame = 0; frame < 100; ++frame) {
    const int width = kWidth - frame / 10;
    renderer.resize(2 * width, kHeight);
    std::vector<EyeView> views(frame % 3 == 2 ? 1 : 2,
                               lookingAhead({0.001 * frame, 0.0, 0.0}, width, kHeight));
    if (views.size() == 2) views[1].x = width;
    renderer.draw(views);
    if (frame % 2 == 1) renderer.drawText(views, "frame " + std::to_string(frame));
    display().present();
    if (frame % 5 == 0) renderer.readImage();
    ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << "in frame " << frame;
  }
}

TEST_F(RendererTest, DrawingTheSameAgainGivesTheSamePicture) {
  TestScene scene;
  addLitBoxes(scene);
  const EyeView view = lookingAhead({}, kWidth, kHeight);
  Renderer renderer(scene, scene.illumination(), kWidth, kHeight);
  const Image first = picture(renderer, {&view, 1});
  renderer.drawText({&view, 1}, "what text leaves behind must not show in the next frame");
  EXPECT_GT(shareDiffering(renderer.readImage(), first, 0), 0.0);
  EXPECT_EQ(shareDiffering(picture(renderer, {&view, 1}), first, 0), 0.0);
}

TEST_F(RendererTest, EmptySceneShowsTheSky) {
  TestScene scene;
  scene.setAmbient({0.4, 0.25, 0.0}, {});
  const Image image = picture(scene, lookingAhead({}, kWidth, kHeight));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      ASSERT_NEAR(linear(value(image, x, y, Red)), 0.4, 0.01);
      ASSERT_NEAR(linear(value(image, x, y, Green)), 0.25, 0.01);
      ASSERT_EQ(value(image, x, y, Blue), 0);
    }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(RendererTest, ResizedDrawsWhatANewOneOfThatSizeDraws) {
  TestScene scene;
  addLitBoxes(scene);
  Renderer renderer(scene, scene.illumination(), kWidth, kHeight);
  for (const auto& [width, height] : {std::pair{200, 90}, {64, 128}, {1, 1}}) {
    const EyeView view = lookingAhead({}, width, height);
    renderer.resize(width, height);
    const Image resized = picture(renderer, {&view, 1});
    EXPECT_EQ(resized.width, width);
    EXPECT_EQ(resized.height, height);
    EXPECT_EQ(shareDiffering(resized, picture(scene, view), 0), 0.0) << width << "x" << height;
  }
}

TEST_F(RendererTest, RefusesSizesThatCannotBeAndGoesOnWithTheOldOne) {
  TestScene scene;
  addLitBoxes(scene);
  const EyeView view = lookingAhead({}, kWidth, kHeight);
  Renderer renderer(scene, scene.illumination(), kWidth, kHeight);
  const Image before = picture(renderer, {&view, 1});
  for (const auto& [width, height] : {std::pair{0, 10}, {10, -1}, {1 << 20, 10}}) {
    const std::string text = complaint([&, w = width, h = height] { renderer.resize(w, h); });
    EXPECT_TRUE(mentions(text, std::to_string(width) + "x" + std::to_string(height))) << text;
    EXPECT_TRUE(mentions(text, "must be 1 to ")) << text;
    EXPECT_EQ(shareDiffering(picture(renderer, {&view, 1}), before, 0), 0.0);
  }
  EXPECT_TRUE(mentions(complaint([&] { Renderer(scene, scene.illumination(), 0, 0); }), "0x0"));
  const RendererSettings coarse{.shadow_resolution = 3};
  EXPECT_TRUE(mentions(complaint([&] { Renderer(scene, scene.illumination(), 8, 8, coarse); }),
                       "shadow resolution 3 must be 16 to "));
}

TEST_F(RendererTest, IdsAreOfTheObjectsWhoseColoursShowAndLeaveThePictureAsItIs) {
  TestScene scene;
  const std::array<const VRObject*, 3> objects = {
      &scene.add<Ellipsoid>({-0.5, 0.0, -2.0}, kRed, Coord3{0.7, 0.7, 0.7}),
      &scene.addMoving<Box>({0.5, 0.0, -2.0}, kGreen, Coord3{0.7, 0.7, 0.7}),
      &scene.add<Box>({0.0, 0.6, -1.5}, kBlue, Coord3{2.0, 0.3, 0.3})};
  Renderer renderer(scene, scene.illumination(), kWidth, kHeight, {.samples = 1});
  const EyeView view = lookingAhead({}, kWidth, kHeight);
  const Image colours = picture(renderer, {&view, 1});
  const IdImage image = renderer.drawIds({&view, 1});
  EXPECT_EQ(renderer.readImage().rgb, colours.rgb);
  ASSERT_EQ(image.ids.size(), static_cast<std::size_t>(kWidth * kHeight));
  for (std::size_t i = 0; i < image.ids.size(); ++i) {
    const VRObject* shown = image.ids[i] == 0 ? nullptr : image.objects.at(image.ids[i] - 1);
    for (const Channel channel : {Red, Green, Blue})
      ASSERT_EQ(shown == objects[channel], colours.rgb[3 * i + channel] > 0) << "pixel " << i;
  }
  renderer.resize(8, 6);
  EXPECT_EQ(renderer.drawIds({}).ids, std::vector<std::uint32_t>(48, 0U)) << "without a view nothing shows";
}

TEST_F(RendererTest, OneTileOfTheShadowMapShowsWhatTwoDoWhereThereIsNoOtherVehicle) {
  TestScene scene;
  addLitBoxes(scene);
  scene.addMoving<Box>({0.0, 0.2, -1.5}, matt(0.8, 0.8, 0.8), Coord3{0.3, 0.02, 0.3});
  const EyeView view = lookingAhead({}, kWidth, kHeight);
  const Image two = picture(scene, view);
  EXPECT_LT(shareDiffering(picture(scene, view, {.two_vehicles = false}), two, 1), 0.002);
  EXPECT_GT(shareDiffering(picture(scene, view, {.shadows = false}), two, 8), 0.004) << "there are shadows";
}

TEST_F(RendererTest, CountsWhatItDraws) {
  TestScene scene;
  addLitBoxes(scene);
  const Renderer renderer(scene, scene.illumination(), 8, 8, {.samples = 1});
  EXPECT_EQ(renderer.report().objects(), 3U);
  EXPECT_GE(renderer.triangleCount(), 12U + 12U + 2U * 16U * 7U);
  EXPECT_EQ(renderer.samples(), 1);
  EXPECT_FALSE(renderer.rendererName().empty());
}

class Text : public DrawingTest {
 protected:
  void SetUp() override {
    DrawingTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    scene_.setAmbient({0.5, 0.5, 0.5}, {});
    renderer_ = std::make_unique<Renderer>(scene_, scene_.illumination(), 2 * kWidth, kHeight);
    views_ = {lookingAhead({}, kWidth, kHeight), lookingAhead({}, kWidth, kHeight)};
    views_[1].x = kWidth;
    blank_ = picture(*renderer_, views_);
  }

  Image withText(std::span<const EyeView> over, const std::string& text) {
    renderer_->draw(views_);
    renderer_->drawText(over, text);
    return renderer_->readImage();
  }

  /// The smallest rectangle that holds every changed pixel of columns x_begin to x_end.
  struct Area {
    int left = 1 << 20;
    int top = 1 << 20;
    int right = -1;
    int bottom = -1;
  };
  Area changed(const Image& image, int x_begin, int x_end) const {
    Area area;
    for (int y = 0; y < kHeight; ++y)
      for (int x = x_begin; x < x_end; ++x)
        if (value(image, x, y, Green) != value(blank_, x, y, Green))
          area = {std::min(area.left, x), std::min(area.top, y), std::max(area.right, x),
                  std::max(area.bottom, y)};
    return area;
  }

  TestScene scene_;
  std::unique_ptr<Renderer> renderer_;
  std::vector<EyeView> views_;
  Image blank_;
};

TEST_F(Text, StandsInTheTopLeftCornerOfEachViewAndGrowsWithWhatItSays) {
  const Image one = withText(views_, "Hi");
  const Area left = changed(one, 0, kWidth);
  EXPECT_EQ(left.left, 0);
  EXPECT_EQ(left.top, 0);
  EXPECT_LT(left.right, kWidth / 2);
  EXPECT_LT(left.bottom, kHeight / 2);
  EXPECT_EQ(shareDiffering(columns(one, 0, kWidth), columns(one, kWidth, 2 * kWidth), 0), 0.0)
      << "the same in both";
  EXPECT_GT(changed(withText(views_, "Hi there"), 0, kWidth).right, left.right);
  EXPECT_GT(changed(withText(views_, "Hi\nthere"), 0, kWidth).bottom, left.bottom);
  EXPECT_EQ(shareDiffering(withText(views_, ""), blank_, 0), 0.0);
}

TEST_F(Text, LettersAreUprightAndUnmirrored) {
  const Image image = withText(views_, "L");
  const Area ground = changed(image, 0, kWidth);
  Area letter;
  for (int y = 0; y <= ground.bottom; ++y)
    for (int x = 0; x <= ground.right; ++x)
      if (value(image, x, y, Green) > value(blank_, x, y, Green))
        letter = {std::min(letter.left, x), std::min(letter.top, y), std::max(letter.right, x),
                  std::max(letter.bottom, y)};
  ASSERT_GT(letter.right, letter.left);
  const auto lit = [&](int x, int y) { return value(image, x, y, Green) > value(blank_, x, y, Green); };
  EXPECT_TRUE(lit(letter.left, letter.top));
  EXPECT_FALSE(lit(letter.right, letter.top));
  EXPECT_TRUE(lit(letter.left, letter.bottom));
  EXPECT_TRUE(lit(letter.right, letter.bottom));
}

TEST_F(Text, StaysInsideItsView) {
  std::string much;
  for (int line = 0; line < 40; ++line) much += std::string(200, 'W') + "\n";
  const Image left_only = withText({views_.data(), 1}, much);
  EXPECT_GT(shareDiffering(columns(left_only, 0, kWidth), columns(blank_, 0, kWidth), 0), 0.9);
  EXPECT_EQ(shareDiffering(columns(left_only, kWidth, 2 * kWidth), columns(blank_, kWidth, 2 * kWidth), 0),
            0.0);
}

TEST_F(Text, BreaksLinesThatAreTooWide) {
  std::string words;
  for (int i = 0; i < 40; ++i) words += "word ";
  const Area one_line = changed(withText(views_, "word"), 0, kWidth);
  const Area area = changed(withText(views_, words), 0, kWidth);
  EXPECT_LT(area.right, kWidth - 1) << "no letter is cut";
  EXPECT_GT(area.bottom, 2 * one_line.bottom);
  views_[0].text_x = views_[1].text_x = 40.0;
  views_[0].text_y = views_[1].text_y = 20.0;
  views_[0].text_width = 60.0;
  const Area moved = changed(withText(views_, words), 0, kWidth);
  EXPECT_EQ(moved.left, 40);
  EXPECT_EQ(moved.top, 20);
  EXPECT_LE(moved.right, 100);
}

TEST_F(Text, TakesWhateverItIsGiven) {
  std::string any;
  for (int c = 0; c < 256; ++c) any += static_cast<char>(c);
  EXPECT_GT(shareDiffering(withText(views_, any), blank_, 0), 0.0);
  EXPECT_GT(shareDiffering(withText(views_, std::string(300'000, '#')), blank_, 0), 0.0);
  EXPECT_EQ(shareDiffering(withText(views_, "\xC3\xA4"), withText(views_, "??"), 0), 0.0);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(HeadlessDisplay, RefusesAPictureWithoutPixels) {
  DisplayConfig config;
  config.width = 0;
  const std::string text = complaint([&] { makeHeadlessDisplay(config); });
  EXPECT_TRUE(mentions(text, "0x480")) << text;
  EXPECT_TRUE(mentions(text, "must be 1 or more") || mentions(text, "both must be 1")) << text;
}

/// In a fresh process, whose environment hides what the display needs: says what makeHeadlessDisplay()
/// complains of.
[[noreturn]] void complainOfDisplay() {
  const std::string text = complaint([] { makeHeadlessDisplay({}); });
  std::fputs(text.c_str(), stderr);
  std::_Exit(text.empty() ? 0 : 1);
}

class MissingDriver : public testing::Test {
 protected:
  MissingDriver() { testing::FLAGS_gtest_death_test_style = "threadsafe"; }
  ~MissingDriver() override {
    for (const std::string& name : set_) unsetenv(name.c_str());
  }
  void hide(const std::string& name, const std::string& value) {
    setenv(name.c_str(), value.c_str(), 1);
    set_.push_back(name);
  }

 private:
  std::vector<std::string> set_;
};

TEST_F(MissingDriver, NoDriverIsAnErrorThatNamesTheRemedy) {
  hide("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent");
  EXPECT_EXIT(complainOfDisplay(), testing::ExitedWithCode(1),
              "no OpenGL 4.5 to draw with headless.*install Mesa");
}

TEST_F(MissingDriver, NoEglLibraryIsAnErrorThatNamesTheRemedy) {
  const std::string folder = testing::TempDir() + "coherency_no_egl_" + std::to_string(::getpid());
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/libEGL.so.1").close();  // found before the real one, and no library
  hide("LD_LIBRARY_PATH", folder);
  EXPECT_EXIT(complainOfDisplay(), testing::ExitedWithCode(1),
              "no EGL to draw with headless.*install libegl1");
  std::filesystem::remove_all(folder);
}

TEST_F(MissingDriver, AnOldDriverIsAnErrorThatNamesItsVersion) {
  if (!anyEglDisplay()) GTEST_SKIP() << "this machine has no EGL display to draw with";
  hide("LIBGL_ALWAYS_SOFTWARE", "1");
  hide("MESA_GL_VERSION_OVERRIDE", "3.3");
  EXPECT_EXIT(complainOfDisplay(), testing::ExitedWithCode(1), "OpenGL 3.3 at most.*install Mesa");
}

}  // namespace
}  // namespace coherency
