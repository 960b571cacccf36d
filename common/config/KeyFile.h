#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace coherency {

/// A key file holds one line: "coherency-key-1 ", 64 hexadecimal digits, an end of line. Only its owner may
/// read it. No error quotes what is in it. The 32 bytes are wire/Key.h's Key.

/// Makes `path` with a new random key, for its owner only. Throws ConfigError where there is a file already
/// or none can be made there.
void makeKeyFile(const std::string& path);

/// Throws ConfigError naming `path` and the remedy: no regular file, open to group or others (a link counts
/// by what it leads to), or contents that are no key.
std::array<std::byte, 32> readKeyFile(const std::string& path);

/// What readKeyFile() does with the contents; the end of line may be missing. Zeros are public, and no key.
std::array<std::byte, 32> parseKeyFile(std::string_view text, const std::string& path);

}  // namespace coherency
