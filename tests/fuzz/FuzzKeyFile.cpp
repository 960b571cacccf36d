#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "common/config/ConfigError.h"
#include "common/config/KeyFile.h"

using namespace coherency;

namespace {

constexpr std::string_view kPrefix = "coherency-key-1 ";

/// The one line that has this key.
std::string lineOf(const std::array<std::byte, 32>& key) {
  std::string line(kPrefix);
  for (const std::byte b : key) {
    line += "0123456789abcdef"[std::to_integer<int>(b >> 4)];
    line += "0123456789abcdef"[std::to_integer<int>(b & std::byte{15})];
  }
  return line + "\n";
}

std::string asWritten(std::string_view text) {
  std::string line(text);
  for (std::size_t i = kPrefix.size(); i < line.size(); ++i) {
    line[i] = static_cast<char>(std::tolower(static_cast<unsigned char>(line[i])));
  }
  return line.ends_with('\n') ? line : line + "\n";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const auto key = parseKeyFile(text, "it.key");
    if (lineOf(key) != asWritten(text) || key == std::array<std::byte, 32>{}) std::abort();
  } catch (const ConfigError&) {
  }
  return 0;
}
