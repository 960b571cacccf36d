#include "common/config/Shipped.h"

#include <filesystem>
#include <set>

#include <fmt/format.h>

namespace coherency {

namespace fs = std::filesystem;

std::string shippedFolder(const std::string& kind) {
  std::error_code ignored;
  const fs::path here = fs::path("configs") / kind;
  if (fs::is_directory(here, ignored)) return here.string();
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (fs::path above = program; above.has_relative_path(); above = above.parent_path())
    if (fs::is_directory(above / here, ignored)) return (above / here).string();
  const fs::path installed = (program / "../share/coherency" / kind).lexically_normal();
  return fs::is_directory(installed, ignored) ? installed.string() : std::string();
}

std::string namesIn(const std::string& folder) {
  std::set<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".toml") names.insert(entry.path().stem().string());
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace coherency
