#pragma once

#include <string>

namespace coherency {

/// Writes `text` beside `path` and renames it into place, so that a reader sees the old file or the new one
/// and nothing between. What is there and no regular
/// file (a device, a pipe) is written to instead. Throws std::runtime_error naming the file, the reason and
/// the remedy.
void replaceFile(const std::string& path, const std::string& text);

}  // namespace coherency
