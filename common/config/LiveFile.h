#pragma once

#include <string>

namespace coherency {

/// A file kept up to date while a program runs. It must be writable at the start; a fault later is said once
/// on stderr and ends nothing.
class LiveFile {
 public:
  /// An empty path stands for no file. Throws std::runtime_error where `text` cannot be written.
  LiveFile(std::string path, const std::string& text);
  void update(const std::string& text);
  /// The last word: throws where it cannot be written.
  void finish(const std::string& text) const;

 private:
  std::string path_;
  bool warned_ = false;
};

}  // namespace coherency
