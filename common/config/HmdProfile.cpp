#include "common/config/HmdProfile.h"

#include <filesystem>

#include <fmt/format.h>

#include "common/config/Shipped.h"
#include "common/config/TomlTable.h"

namespace coherency {
namespace {

FieldOfView readView(TomlTable& root, std::string_view key) {
  if (!root.has(key)) throw root.error(key, "is missing; give left, right, down and up in degrees");
  TomlTable eye = root.table(key);
  for (const auto* angle : {"left", "right", "down", "up"})
    if (!eye.has(angle)) throw eye.error(angle, "is missing; degrees from the optical axis");
  const double left = eye.number("left", 0.0, -89.0, 89.0);
  const double right = eye.number("right", 0.0, -89.0, 89.0);
  const double down = eye.number("down", 0.0, -89.0, 89.0);
  const double up = eye.number("up", 0.0, -89.0, 89.0);
  eye.finish();
  if (left + right <= 0.0) throw eye.error("left", "left + right must be more than 0 degrees");
  if (down + up <= 0.0) throw eye.error("down", "down + up must be more than 0 degrees");
  return fieldOfViewFromDegrees(left, right, down, up);
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
  profile.left = readView(root, "left");
  profile.right = readView(root, "right");
  root.finish();
  return profile;
}

FieldOfView monoView(const HmdProfile& profile) {
  const FieldOfView& l = profile.left;
  const FieldOfView& r = profile.right;
  return {(l.tan_left + r.tan_left) / 2.0, (l.tan_right + r.tan_right) / 2.0, (l.tan_down + r.tan_down) / 2.0,
          (l.tan_up + r.tan_up) / 2.0};
}

FieldOfView fitToPicture(const FieldOfView& view, int width, int height) {
  const double wanted = (view.tan_left + view.tan_right) * height / width;
  const double factor = wanted / (view.tan_down + view.tan_up);
  return {view.tan_left, view.tan_right, view.tan_down * factor, view.tan_up * factor};
}

}  // namespace coherency
