#pragma once

#include <string>

namespace coherency {

/// Writes `text` beside `path` and renames it into place, so that a reader sees the old file or the new one
/// and nothing between. What is there and no regular file (a device, a pipe) is written to instead. Throws
/// std::runtime_error naming the file, the reason and the remedy.
void replaceFile(const std::string& path, const std::string& text);

/// Whether replaceFile() can be expected to work, without touching anything: throws ConfigError naming
/// `option` where the folder is missing or may not be written to, or where `path` is a folder. An empty path
/// stands for no file.
void checkReplaceable(const std::string& option, const std::string& path);

}  // namespace coherency
