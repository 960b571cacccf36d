#include "common/config/SceneFile.h"

#include <charconv>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "common/config/Shipped.h"
#include "common/config/TomlTable.h"
#include "common/math/FixedPoint.h"
#include "common/world/Catalogue.h"
#include "common/world/Names.h"

namespace coherency {
namespace {

constexpr double kFar = kWorldLimit;
constexpr double kDegree = kTurn / 360.0;

struct Reference {
  std::string name;  ///< of the session's scene, with its count
  std::string file;
  std::int64_t count = 0;
};

std::int64_t countIn(const std::string& scene, std::string_view digits) {
  std::int64_t count = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  if (read.ec != std::errc{} || read.ptr != digits.data() + digits.size() || count < 1 ||
      count > kMaxSceneParts)
    throw ConfigError(fmt::format("scene \"{}\": after the colon must stand a whole number from 1 to {}",
                                  scene, kMaxSceneParts));
  return count;
}

Reference resolve(const std::string& scene, const std::string& folder) {
  const std::filesystem::path path(scene);
  if (path.extension() == ".toml") {
    Reference file{path.stem().string(), scene};
    if (!isSceneName(file.name))
      throw ConfigError(
          fmt::format("{}: the file's name is the scene's, which every machine shows: it must be of A-Z a-z "
                      "0-9 _ - . only; rename the file",
                      scene));
    return file;
  }
  const std::size_t colon = scene.find(':');
  const std::string name = scene.substr(0, colon);
  const std::string there_are = fmt::format("there are, in {}: {}", folder, namesIn(folder));
  if (!isSceneName(scene) || name.empty())
    throw ConfigError(
        fmt::format("scene \"{}\" is no name, which is of A-Z a-z 0-9 _ - . only, and no path, "
                    "which ends in .toml; {}",
                    scene, there_are));
  Reference reference{scene, (std::filesystem::path(folder) / (name + ".toml")).lexically_normal().string()};
  if (colon != std::string::npos) reference.count = countIn(scene, std::string_view(scene).substr(colon + 1));
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(reference.file, ignored))
    throw ConfigError(fmt::format("scene \"{}\" is not known; {}", name, there_are));
  return reference;
}

/// [x, z, heading in degrees] on the floor.
BasePose readBase(TomlTable& table, std::string_view key, const BasePose& fallback) {
  const std::vector<double> values = table.numbers(key, 3, -kFar, kFar);
  return values.empty() ? fallback : basePose(values[0], values[1], values[2] * kDegree);
}

std::string readKind(TomlTable& table) {
  if (!table.has("kind"))
    throw table.error("kind",
                      "is missing; write what the object is, as kind = \"table\" (motion_server "
                      "--list-objects lists what there is)");
  std::string kind = table.text("kind", "");
  if (findKind(kind) != nullptr) return kind;
  std::vector<std::string_view> known;
  for (const CatalogueEntry& e : catalogue()) known.push_back(e.kind);
  throw table.error("kind",
                    fmt::format("\"{}\" is no kind of object; there are {}", kind, fmt::join(known, ", ")));
}

ObjectPlacement readObject(TomlTable& table, std::int64_t count) {
  ObjectPlacement object;
  object.kind = readKind(table);
  object.name = table.plainText("name", object.kind);
  const std::vector<double> at = table.numbers("position", 3, -kFar, kFar);
  if (!at.empty())
    object.place = {nanometresFromMetres(at[0]), nanometresFromMetres(at[1]), nanometresFromMetres(at[2]), 0};
  object.place.heading_units = unitsFromRadians(table.number("heading", 0.0, -3600.0, 3600.0) * kDegree);
  object.colour = table.text("colour", "");
  if (findKind(object.kind)->counted)
    object.count = static_cast<std::int32_t>(table.integer("count", count, 1, kMaxSceneParts));
  table.finish();
  if (const auto fault = faultOf(object)) throw table.error(fault->key, fault->what);
  return object;
}

/// What several objects can have wrong together, with the line of the one that is too much.
class ObjectReader {
 public:
  explicit ObjectReader(std::int64_t count) : count_(count) {}

  ObjectPlacement read(TomlTable& table) {
    ObjectPlacement object = readObject(table, count_);
    if (!names_.insert(object.name).second)
      throw table.error(
          "name", fmt::format("two objects are called '{}'; give one of them another name", object.name));
    parts_ += object.count;
    if (parts_ > kMaxSceneParts)
      throw table.error("count", fmt::format("all counts of a scene together may be {}; with this one they "
                                             "are {}",
                                             kMaxSceneParts, parts_));
    count_taken_ = count_taken_ || (object.count > 0 && !table.has("count"));
    return object;
  }
  bool countTaken() const { return count_taken_; }

 private:
  std::int64_t count_;
  std::int64_t parts_ = 0;
  bool count_taken_ = false;
  std::set<std::string> names_;
};

void readObjects(TomlTable& root, const Reference& reference, SceneDescription& description) {
  std::vector<TomlTable> tables = root.tables("object");
  if (tables.size() > kMaxSceneObjects)
    throw root.error("object",
                     fmt::format("{} objects; a scene may name {}", tables.size(), kMaxSceneObjects));
  ObjectReader reader(reference.count);
  for (TomlTable& table : tables) description.objects.push_back(reader.read(table));
  if (reference.count > 0 && !reader.countTaken())
    throw ConfigError(fmt::format("scene \"{}\": nothing in {} takes its count from there; write \"{}\"",
                                  reference.name, reference.file,
                                  reference.name.substr(0, reference.name.find(':'))));
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
  description.name = reference.name;
  description.operator_shown = root.oneOf("operator", "whole", {"whole", "eyes"}) == "whole";
  description.driving = root.flag("driving", true);
  description.start = readBase(root, "start", {});
  description.workplace = readBase(root, "workplace", description.start);
  description.robot = readRobot(root);
  description.scatter = readScatter(root);
  readObjects(root, reference, description);
  root.finish();
  return description;
}

std::string sceneFile(const std::string& scene, const std::string& folder) {
  return resolve(scene, folder).file;
}

}  // namespace coherency
