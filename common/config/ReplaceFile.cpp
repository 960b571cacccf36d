#include "common/config/ReplaceFile.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

namespace coherency {

void replaceFile(const std::string& path, const std::string& text) {
  const std::string beside = path + ".new";
  std::ofstream file(beside, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file || std::rename(beside.c_str(), path.c_str()) != 0) {
    const int why = errno;
    std::remove(beside.c_str());
    throw std::runtime_error(
        fmt::format("{}: cannot be written: {}; name a file in a folder that exists and can be written", path,
                    std::strerror(why)));
  }
}

}  // namespace coherency
