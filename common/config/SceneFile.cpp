#include "common/config/SceneFile.h"

#include <charconv>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "common/config/TomlTable.h"
#include "common/math/FixedPoint.h"
#include "common/world/Catalogue.h"

namespace coherency {
namespace {

constexpr double kFar = 1e9;  // m, the end of the world
constexpr double kDegree = kTurn / 360.0;
constexpr std::int64_t kMaxCount = 10'000'000;
constexpr std::size_t kMaxObjects = 200;

/// Names of the scenes in a folder, in order.
std::string known(const std::string& folder) {
  std::set<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".toml") names.insert(entry.path().stem().string());
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

struct Reference {
  std::string name;
  std::string file;
  std::int64_t count = 0;
};

Reference resolve(const std::string& scene, const std::string& folder) {
  const std::filesystem::path path(scene);
  if (path.extension() == ".toml") return {path.stem().string(), scene};
  Reference reference;
  const std::size_t colon = scene.find(':');
  reference.name = scene.substr(0, colon);
  if (colon != std::string::npos) {
    const std::string_view digits = std::string_view(scene).substr(colon + 1);
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), reference.count);
    if (read.ec != std::errc{} || read.ptr != digits.data() + digits.size() || reference.count < 1 ||
        reference.count > kMaxCount)
      throw ConfigError(fmt::format("scene \"{}\": after the colon must stand a whole number from 1 to {}",
                                    scene, kMaxCount));
  }
  reference.file = (std::filesystem::path(folder) / (reference.name + ".toml")).lexically_normal().string();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(reference.file, ignored))
    throw ConfigError(fmt::format("scene \"{}\" is not known; there are, in {}: {}", reference.name, folder,
                                  known(folder)));
  return reference;
}

/// [x, z, heading in degrees] on the floor.
BasePose readBase(TomlTable& table, std::string_view key, const BasePose& fallback) {
  const std::vector<double> values = table.numbers(key, 3, -kFar, kFar);
  return values.empty() ? fallback : basePose(values[0], values[1], values[2] * kDegree);
}

ObjectPlacement readObject(TomlTable& table, std::int64_t count) {
  ObjectPlacement object;
  object.kind = table.text("kind", "");
  const CatalogueEntry* entry = findKind(object.kind);
  if (entry == nullptr) {
    std::string known;
    for (const CatalogueEntry& e : catalogue()) known += (known.empty() ? "" : ", ") + std::string(e.kind);
    throw table.error("kind", fmt::format("\"{}\" is no kind of object; there are {}", object.kind, known));
  }
  object.name = table.text("name", object.kind);
  const std::vector<double> at = table.numbers("position", 3, -kFar, kFar);
  if (!at.empty())
    object.place = {nanometresFromMetres(at[0]), nanometresFromMetres(at[1]), nanometresFromMetres(at[2]), 0};
  object.place.heading_units = unitsFromRadians(table.number("heading", 0.0, -3600.0, 3600.0) * kDegree);
  object.colour = table.text("colour", "");
  if (entry->counted) object.count = static_cast<std::int32_t>(table.integer("count", count, 1, kMaxCount));
  table.finish();
  return object;
}

std::optional<RobotPlacement> readRobot(TomlTable& root) {
  if (!root.has("robot")) {
    root.table("robot");
    return std::nullopt;
  }
  TomlTable table = root.table("robot");
  RobotPlacement robot;
  robot.start = readBase(table, "start", {});
  robot.workplace = readBase(table, "workplace", robot.start);
  table.finish();
  return robot;
}

std::optional<ScatterArea> readScatter(TomlTable& root) {
  const std::vector<double> area = root.numbers("scatter", 4, -kFar, kFar);
  if (area.empty()) return std::nullopt;
  if (area[0] > area[1] || area[2] > area[3])
    throw root.error("scatter", "must be [x from, x to, z from, z to], each from no larger than its to");
  return ScatterArea{area[0], area[1], area[2], area[3]};
}

}  // namespace

SceneDescription readScene(const std::string& scene, const std::string& folder) {
  const Reference reference = resolve(scene, folder);
  const toml::table parsed = parseTomlFile(reference.file);
  TomlTable root(&parsed, reference.file, "");
  SceneDescription description;
  description.name = reference.count > 0 ? scene : reference.name;
  description.operator_shown = root.oneOf("operator", "whole", {"whole", "eyes"}) == "whole";
  description.driving = root.flag("driving", true);
  description.start = readBase(root, "start", {});
  description.workplace = readBase(root, "workplace", description.start);
  description.robot = readRobot(root);
  description.scatter = readScatter(root);
  std::vector<TomlTable> objects = root.tables("object");
  if (objects.size() > kMaxObjects)
    throw root.error("object", fmt::format("{} objects; a scene may name {}", objects.size(), kMaxObjects));
  for (TomlTable& object : objects) description.objects.push_back(readObject(object, reference.count));
  root.finish();
  return description;
}

}  // namespace coherency
