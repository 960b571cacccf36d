#include "common/config/RigFile.h"

#include <filesystem>

#include "common/config/TomlTable.h"

namespace coherency {

Rig readRig(const std::string& path, std::vector<std::string>* absent) {
  const toml::table root = parseTomlFile(path);
  TomlTable table(&root, path, "");
  Rig rig;
  rig.name = table.plainText("name", std::filesystem::path(path).stem().string());
  for (const RigField& field : rigFields()) {
    if (absent != nullptr && !table.has(field.name)) absent->emplace_back(field.name);
    rig.*field.value = table.number(field.name, rig.*field.value, field.min, field.max);
  }
  table.finish();
  return rig;
}

}  // namespace coherency
