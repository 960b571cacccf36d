#include "common/config/LiveFile.h"

#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "common/config/ReplaceFile.h"

namespace coherency {

LiveFile::LiveFile(std::string path, const std::string& text) : path_(std::move(path)) {
  finish(text);
}

void LiveFile::update(const std::string& text) {
  try {
    finish(text);
    warned_ = false;
  } catch (const std::exception& e) {
    if (!warned_) fmt::print(stderr, "{} (going on without)\n", e.what());
    warned_ = true;
  }
}

void LiveFile::finish(const std::string& text) const {
  if (!path_.empty()) replaceFile(path_, text);
}

}  // namespace coherency
