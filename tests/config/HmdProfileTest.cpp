// Displays: what comes with the programs, and what is refused with place and remedy.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "common/config/ConfigError.h"
#include "common/config/HmdProfile.h"

namespace coherency {
namespace {

namespace fs = std::filesystem;

constexpr double kDegree = std::numbers::pi / 180.0;

const std::string kEye = "left = 40.0\nright = 40.0\ndown = 40.0\nup = 40.0\n";
const std::string kLens = R"(centre = [500.0, 600.0]
unit_px = 500.0
tangent = 1.0
radius = 1.2
red = [1.0, 0.2, 0.1, 0.0, 0.0]
green = [1.0, 0.22, 0.1, 0.0, 0.0]
blue = [1.0, 0.24, 0.1, 0.0, 0.0]
)";
const std::string kPanel = "panel = [1000, 1200]\n";

class HmdProfileTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("coherency_hmd_") + test->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  HmdProfile read(const std::string& text) const {
    std::ofstream(folder_ / "it.toml") << text;
    return readHmdProfile((folder_ / "it.toml").string());
  }

  void expectRefused(const std::string& text, const std::string& place, const std::string& words) const {
    std::string message = "no error";
    try {
      read(text);
    } catch (const ConfigError& e) {
      message = e.what();
    }
    EXPECT_NE(message.find("it.toml" + place), std::string::npos) << message;
    EXPECT_NE(message.find(words), std::string::npos) << message;
  }

  /// A profile of two eyes with the same lens, one of its lines changed.
  static std::string lenses(const std::string& line = "", const std::string& instead = "") {
    std::string lens = kLens;
    if (!line.empty()) lens.replace(lens.find(line), line.size(), instead);
    return kPanel + "[left.lens]\n" + lens + "[right.lens]\n" + lens;
  }

  fs::path folder_;
};

TEST_F(HmdProfileTest, ShippedOnesHaveNamesAndSources) {
  int files = 0;
  for (const auto& entry : fs::directory_iterator(COHERENCY_CONFIGS "/hmds")) {
    ++files;
    const std::string name = entry.path().stem();
    SCOPED_TRACE(name);
    EXPECT_NE(hmdNames().find(name), std::string::npos) << hmdNames();
    EXPECT_EQ(readHmdProfile(name).name, name);
    EXPECT_FALSE(readHmdProfile(name).source.empty());
  }
  EXPECT_GE(files, 8);
  EXPECT_THROW(readHmdProfile("narrow"), ConfigError);
  EXPECT_THROW(readHmdProfile("a/b"), ConfigError);
}

/// What two independent parts of a source say agrees: the view that the runtime has drawn, and what the lens
/// shows by its curves.
TEST_F(HmdProfileTest, TheVivesLensShowsNearlyWhatItsRuntimeDraws) {
  const FieldOfView view = readHmdProfile("vive").left.view;
  EXPECT_NEAR(std::atan(view.tan_left) / kDegree, 54.4, 1.5);
  EXPECT_NEAR(std::atan(view.tan_up) / kDegree, 55.7, 2.5);
  EXPECT_LT(view.tan_left, 1.397283) << "within what is drawn there";
  EXPECT_LT(view.tan_up, 1.464221);
}

TEST_F(HmdProfileTest, LeftAndRightAreMirrored) {
  for (const char* name : {"generic", "rift_dk1", "rift_dk2", "rift_cv1", "wide"}) {
    const HmdProfile hmd = readHmdProfile(name);
    EXPECT_NEAR(hmd.left.view.tan_left, hmd.right.view.tan_right, 1e-9) << name;
    EXPECT_NEAR(hmd.left.view.tan_right, hmd.right.view.tan_left, 1e-9) << name;
    EXPECT_NEAR(hmd.left.view.tan_up, hmd.right.view.tan_up, 1e-9) << name;
  }
}

TEST_F(HmdProfileTest, NeedsBothEyesAndAPicture) {
  EXPECT_NO_THROW(read("[left]\n" + kEye + "[right]\n" + kEye));
  expectRefused("[left]\n" + kEye, ":1:", "right: is missing");
  expectRefused("[left]\n" + kEye + "[right]\nleft = 40.0\n", ":6:", "right.right: is missing");
  expectRefused("[left]\n" + kEye + "[right]\nleft = -40.0\nright = 40.0\ndown = 1.0\nup = 1.0\n",
                ":7:", "left + right must be more than 0");
}

TEST_F(HmdProfileTest, TheEyesDistanceIsTheRigs) {
  for (const char* key : {"eye_distance = 0.07\n", "ipd = 0.07\n"})
    expectRefused(key + ("[left]\n" + kEye + "[right]\n" + kEye), ":1:", "is not a known key here");
}

TEST_F(HmdProfileTest, EyesMayBeCanted) {
  const HmdProfile hmd = read("[left]\naxis = [5.0, 2.0, -1.0]\n" + kEye + "[right]\n" + kEye);
  EXPECT_DOUBLE_EQ(hmd.left.axis.yaw, 5.0 * kDegree);
  EXPECT_DOUBLE_EQ(hmd.left.axis.pitch, 2.0 * kDegree);
  EXPECT_DOUBLE_EQ(hmd.left.axis.roll, -1.0 * kDegree);
  EXPECT_EQ(hmd.right.axis, YawPitchRoll{});
  expectRefused("[left]\naxis = [5.0]\n" + kEye + "[right]\n" + kEye, ":2:", "must be 3 numbers");
}

TEST_F(HmdProfileTest, WithALensTheViewFollows) {
  const HmdProfile hmd = read(lenses());
  ASSERT_TRUE(hmd.left.lens && hmd.right.lens);
  const double edge = 1.0 + 0.24 + 0.1;  // of blue, where the panel ends
  EXPECT_GE(hmd.left.view.tan_right, edge);
  const auto with = [&](double degrees) {
    return kPanel + "[left]\nright = " + std::to_string(degrees) + "\n[left.lens]\n" + kLens +
           "[right.lens]\n" + kLens;
  };
  const double shown = std::atan(hmd.left.view.tan_right) / kDegree;
  EXPECT_NO_THROW(read(with(shown + 0.4)));
  expectRefused(with(shown + 1.0), ":3:", "contradicts the lens, which shows");
}

TEST_F(HmdProfileTest, LensesThatCannotBeAreRefused) {
  EXPECT_NO_THROW(read(lenses()));
  expectRefused("[left.lens]\n" + kLens + "[right.lens]\n" + kLens, ":1:", "needs the panel it is before");
  expectRefused(kPanel + "[left.lens]\n" + kLens + "[right]\n" + kEye,
                ":10:", "has no lens, and the other eye has one");
  expectRefused(lenses("radius = 1.2\n"), ":2:", "left.lens.radius: is missing");
  expectRefused(lenses("[500.0, 600.0]", "[500.0, 1200.0]"), ":3:", "is not on the panel");
  expectRefused(lenses("[500.0, 600.0]", "[500.0]"), ":3:", "must be 2 numbers");
  expectRefused(lenses("unit_px = 500.0", "unit_px = 0.0"), ":4:", "from 1 to");
  expectRefused(lenses("[1.0, 0.22, 0.1, 0.0, 0.0]", "[1.0, 0.22, 0.1]"), ":8:", "must be 5 numbers");
  expectRefused(lenses("[1.0, 0.22, 0.1, 0.0, 0.0]", "[1.0, -0.3, 0.0, 0.0, 0.0]"), ":8:",
                "does not rise from the lens centre to radius 1.2, so that a point would be seen twice; it "
                "does up to 1.05");
  expectRefused(lenses("radius = 1.2", "radius = 1.2\nform = \"cubic\""),
                ":7:", "must be one of: polynomial, reciprocal");
  expectRefused(lenses("radius = 1.2", "radius = 1.2\nangle = 3"), ":7:", "is not a known key");
  expectRefused(lenses("tangent = 1.0", "tangent = 40.0"), ":2:", "a flat picture can be 85 at most");
  expectRefused(lenses("[1.0, 0.22, 0.1, 0.0, 0.0]", "[1e-9, 0.5, 0.1, 0.0, 0.0]"),
                ":2:", "more than 16384 pixels");
  expectRefused(lenses("[1.0, 0.22, 0.1, 0.0, 0.0]", "[nan, 0.5, 0.1, 0.0, 0.0]"),
                ":8:", "must be 5 numbers");
  expectRefused("panel = [1000.5, 1200]\n", ":1:", "whole numbers of pixels");
  expectRefused("panel = [4, 1200]\n", ":1:", "must be 2 numbers from 16");
}

TEST_F(HmdProfileTest, AScreenStandsInPlaceOfBothEyes) {
  const std::string screen = "[screen]\nwidth = 0.5\nheight = 0.3\ndistance = 0.6\n";
  const HmdProfile hmd = read(screen + "tilt = 10.0\nabove = -0.2\n");
  ASSERT_TRUE(hmd.screen);
  EXPECT_EQ(hmd.screen->width_m, 0.5);
  EXPECT_DOUBLE_EQ(hmd.screen->tilt_rad, 10.0 * kDegree);
  expectRefused("[screen]\nwidth = 0.5\nheight = 0.3\n", ":1:", "screen.distance: is missing");
  expectRefused(screen + "[left]\n" + kEye, ":5:", "follows from where the eyes are");
  expectRefused(screen + "tilt = 90.0\n", ":5:", "from -80 to 80");
  expectRefused("[screen]\nwidth = -0.5\nheight = 0.3\ndistance = 1.0\n", ":2:", "out of range");
}

/// Its three blocks: a display without a lens, a lens table, a screen.
TEST_F(HmdProfileTest, TheExamplesInTheDocumentationLoad) {
  std::ifstream file(COHERENCY_DOCS "/displays.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::vector<std::string> blocks;
  const std::string begin = "```toml\n";
  for (auto at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1))
    blocks.push_back(text.substr(at + begin.size(), text.find("```", at + 1) - at - begin.size()));
  ASSERT_EQ(blocks.size(), 3U);
  EXPECT_EQ(read(blocks[0]).name, "mine");
  std::string right = blocks[1];
  right.replace(right.find("[left"), 5, "[right");
  EXPECT_TRUE(read("panel = [1080, 1200]\n" + blocks[1] + right).left.lens);
  EXPECT_TRUE(read(blocks[2]).screen);
}

TEST_F(HmdProfileTest, FittingKeepsThePixelsShapeAndTheHorizontalView) {
  const FieldOfView view = fieldOfViewFromDegrees(52.0, 44.0, 30.0, 50.0);
  const FieldOfView square = fitToPicture(view, {}, 640, 480);
  EXPECT_EQ(square.tan_left, view.tan_left);
  EXPECT_EQ(square.tan_right, view.tan_right);
  EXPECT_NEAR((square.tan_left + square.tan_right) / 640, (square.tan_down + square.tan_up) / 480, 1e-15);
  EXPECT_NEAR(square.tan_down / square.tan_up, view.tan_down / view.tan_up, 1e-15);

  const PanelSize panel{1000, 900};
  const FieldOfView whole = fitToPicture(view, panel, 1000, 900);
  EXPECT_NEAR(whole.tan_up, view.tan_up, 1e-15) << "on its own panel the display's own view";
  EXPECT_NEAR(fitToPicture(view, panel, 500, 450).tan_up, view.tan_up, 1e-15);
  EXPECT_NEAR(fitToPicture(view, panel, 1000, 450).tan_up, 0.5 * view.tan_up, 1e-15);
}

}  // namespace
}  // namespace coherency
