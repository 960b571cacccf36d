#include "common/config/ReplaceFile.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "common/config/ConfigError.h"

namespace coherency {

namespace fs = std::filesystem;

void replaceFile(const std::string& path, const std::string& text) {
  // A device or a pipe is written to, not replaced; a link stays one.
  std::error_code missing;
  const fs::path target = fs::exists(path, missing) ? fs::canonical(path) : fs::path(path);
  const bool in_place = fs::exists(target, missing) && !fs::is_regular_file(target);
  const fs::path written = in_place ? target : fs::path(target.string() + ".new");
  errno = 0;
  std::ofstream file(written, std::ios::binary);
  file << text;
  file.close();
  std::error_code failure(file ? 0 : (errno != 0 ? errno : EIO), std::generic_category());
  if (!failure && !in_place) fs::rename(written, target, failure);
  if (!failure) return;
  std::error_code ignored;
  if (!in_place) fs::remove(written, ignored);
  throw std::runtime_error(fmt::format(
      "{}: cannot be written: {}; name a file where there is room and permission", path, failure.message()));
}

void checkReplaceable(const std::string& option, const std::string& path) {
  if (path.empty()) return;
  const auto refuse = [&](const std::string& why) {
    throw ConfigError(
        fmt::format("{} {}: {}; name a file where there is room and permission", option, path, why));
  };
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) refuse("is a folder");
  const bool in_place = fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
  const fs::path folder = fs::path(path).parent_path();
  const fs::path written = in_place ? fs::path(path) : (folder.empty() ? fs::path(".") : folder);
  if (!in_place && !fs::is_directory(written, ignored)) refuse("there is no folder " + written.string());
  if (::access(written.c_str(), W_OK) != 0)
    refuse("cannot be written: " + std::generic_category().message(errno));
}

}  // namespace coherency
