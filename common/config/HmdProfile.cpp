#include "common/config/HmdProfile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>

#include "common/config/LensTable.h"
#include "common/config/Shipped.h"
#include "common/config/TomlTable.h"

namespace coherency {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kAgreement = 0.5;  // degrees that a given side may be off what the lens shows
constexpr double kWidest = 85.0;    // degrees; no flat picture is drawn farther
constexpr double kMostPixels = 16384.0;

struct Side {
  const char* key;
  double FieldOfView::*tangent;
};
constexpr std::array<Side, 4> kSides = {{{"left", &FieldOfView::tan_left},
                                         {"right", &FieldOfView::tan_right},
                                         {"down", &FieldOfView::tan_down},
                                         {"up", &FieldOfView::tan_up}}};

FieldOfView readView(TomlTable& eye) {
  for (const Side& side : kSides)
    if (!eye.has(side.key)) throw eye.error(side.key, "is missing; degrees from the optical axis");
  const double left = eye.number("left", 0.0, -89.0, 89.0);
  const double right = eye.number("right", 0.0, -89.0, 89.0);
  const double down = eye.number("down", 0.0, -89.0, 89.0);
  const double up = eye.number("up", 0.0, -89.0, 89.0);
  if (left + right <= 0.0) throw eye.error("left", "left + right must be more than 0 degrees");
  if (down + up <= 0.0) throw eye.error("down", "down + up must be more than 0 degrees");
  return fieldOfViewFromDegrees(left, right, down, up);
}

/// What the lens shows; sides that are given must say the same.
FieldOfView viewThrough(TomlTable& eye, const Lens& lens, const PanelSize& panel) {
  const FieldOfView view = lens.view(panel.width, panel.height);
  const double tangents = std::max(view.tan_left + view.tan_right, view.tan_down + view.tan_up);
  if (!(tangents * lens.pixelsPerTangent() <= kMostPixels))
    throw eye.error(
        "lens", fmt::format("shows its middle so large that a picture would need more than {} pixels to a "
                            "side; are c0 of each colour, unit_px and tangent right?",
                            kMostPixels));
  for (const Side& side : kSides) {
    const double shown = std::atan(view.*side.tangent) / kDegree;
    if (shown > kWidest)
      throw eye.error("lens", fmt::format("shows {:.1f} degrees to the {} side; a flat picture can be {} at "
                                          "most: give a smaller radius",
                                          shown, side.key, kWidest));
    const double given = eye.number(side.key, shown, -89.0, 89.0);
    if (std::abs(given - shown) > kAgreement)
      throw eye.error(side.key,
                      fmt::format("{} contradicts the lens, which shows {:.1f} degrees of the panel; "
                                  "leave it out, or correct one of the two",
                                  given, shown));
  }
  return view;
}

YawPitchRoll readAxis(TomlTable& eye) {
  const auto degrees = eye.numbers("axis", 3, -89.0, 89.0);
  if (degrees.empty()) return {};
  return {degrees[0] * kDegree, degrees[1] * kDegree, degrees[2] * kDegree};
}

EyeDisplay readEye(TomlTable& root, std::string_view key, const std::optional<PanelSize>& panel) {
  if (!root.has(key))
    throw root.error(key, "is missing; give left, right, down and up in degrees, or a lens");
  TomlTable eye = root.table(key);
  EyeDisplay display;
  display.axis = readAxis(eye);
  if (eye.has("lens")) {
    if (!panel)
      throw eye.error("lens", "needs the panel it is before: panel = [WIDTH, HEIGHT], pixels an eye");
    display.lens = readLens(eye, *panel);
    display.view = viewThrough(eye, *display.lens, *panel);
  } else {
    display.view = readView(eye);
  }
  eye.finish();
  return display;
}

std::optional<PanelSize> readPanel(TomlTable& root) {
  const auto pixels = root.numbers("panel", 2, 16.0, 16384.0);
  if (pixels.empty()) return std::nullopt;
  if (pixels[0] != std::floor(pixels[0]) || pixels[1] != std::floor(pixels[1]))
    throw root.error("panel", "must be whole numbers of pixels, as [1080, 1200]");
  return PanelSize{static_cast<int>(pixels[0]), static_cast<int>(pixels[1])};
}

Screen readScreen(TomlTable& root) {
  TomlTable table = root.table("screen");
  for (const char* key : {"width", "height", "distance"})
    if (!table.has(key)) throw table.error(key, "is missing; metres, as a ruler measures");
  Screen screen;
  screen.width_m = table.number("width", 0.0, 0.01, 100.0);
  screen.height_m = table.number("height", 0.0, 0.01, 100.0);
  screen.distance_m = table.number("distance", 0.0, 0.05, 100.0);
  screen.above_m = table.number("above", 0.0, -10.0, 10.0);
  screen.tilt_rad = table.number("tilt", 0.0, -80.0, 80.0) * kDegree;
  table.finish();
  for (const char* eye : {"left", "right"})
    if (root.has(eye)) throw root.error(eye, "a screen's view follows from where the eyes are; leave it out");
  return screen;
}

std::string fileOf(const std::string& name) {
  const std::filesystem::path path(name);
  if (path.extension() == ".toml" || path.has_parent_path()) return name;
  const std::string folder = shippedFolder("hmds");
  std::string file = (std::filesystem::path(folder) / (name + ".toml")).string();
  std::error_code ignored;
  if (folder.empty() || !std::filesystem::is_regular_file(file, ignored))
    throw ConfigError(
        fmt::format("HMD profile \"{}\" is not known; there are {}, or name a TOML file", name, hmdNames()));
  return file;
}

}  // namespace

std::string hmdNames() {
  return namesIn(shippedFolder("hmds"));
}

HmdProfile readHmdProfile(const std::string& name) {
  const std::string path = fileOf(name);
  const toml::table parsed = parseTomlFile(path);
  TomlTable root(&parsed, path, "");
  HmdProfile profile;
  profile.name = root.text("name", "unnamed");
  profile.source = root.text("source", "");
  profile.near_m = root.number("near_m", profile.near_m, 1e-4, 1.0);
  profile.panel = readPanel(root);
  if (root.has("screen")) {
    profile.screen = readScreen(root);
  } else {
    profile.left = readEye(root, "left", profile.panel);
    profile.right = readEye(root, "right", profile.panel);
    if (profile.left.lens.has_value() != profile.right.lens.has_value())
      throw root.error(profile.left.lens ? "right" : "left", "has no lens, and the other eye has one");
  }
  root.finish();
  return profile;
}

FieldOfView monoView(const HmdProfile& profile) {
  const FieldOfView& l = profile.left.view;
  const FieldOfView& r = profile.right.view;
  return {(l.tan_left + r.tan_left) / 2.0, (l.tan_right + r.tan_right) / 2.0, (l.tan_down + r.tan_down) / 2.0,
          (l.tan_up + r.tan_up) / 2.0};
}

FieldOfView fitToPicture(const FieldOfView& view, const std::optional<PanelSize>& panel, int width,
                         int height) {
  const double across = view.tan_left + view.tan_right;
  const double upright = view.tan_down + view.tan_up;
  const double pixel_shape = panel ? upright / panel->height / (across / panel->width) : 1.0;
  const double factor = across * height / width * pixel_shape / upright;
  return {view.tan_left, view.tan_right, view.tan_down * factor, view.tan_up * factor};
}

}  // namespace coherency
