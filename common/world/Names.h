#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace coherency {

inline constexpr std::size_t kMaxText = 200;  ///< bytes of a name, or of anything else said to people

/// Scene names: 1 to kMaxText of a-z, A-Z, 0-9 and `_ - . :`.
bool isSceneName(std::string_view name);
/// At most kMaxText printable ASCII characters: safe to show on any terminal and in a picture.
bool isPlainText(std::string_view text);
/// `text` made so: other characters become `?`, and what is too long is cut.
std::string plainText(std::string_view text);

}  // namespace coherency
