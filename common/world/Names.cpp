#include "common/world/Names.h"

#include <algorithm>

namespace coherency {
namespace {

bool isPrintable(char c) {
  return c >= 0x20 && c <= 0x7e;
}

}  // namespace

bool isSceneName(std::string_view name) {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.:";
  return !name.empty() && name.size() <= kMaxText &&
         name.find_first_not_of(allowed) == std::string_view::npos;
}

bool isPlainText(std::string_view text) {
  return text.size() <= kMaxText && std::all_of(text.begin(), text.end(), isPrintable);
}

std::string plainText(std::string_view text) {
  std::string plain(text.substr(0, kMaxText));
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return !isPrintable(c); }, '?');
  return plain;
}

}  // namespace coherency
