#pragma once

#include <array>
#include <cstddef>

namespace coherency {

/// 256 bits that only those may know who may speak. Never printed.
using Key = std::array<std::byte, 32>;

/// Public knowledge: seals made with what follows from it hide from who only listens, and prove nothing.
inline constexpr Key kNoKey{};

/// From libsodium's generator, which is the operating system's. Throws std::runtime_error where libsodium
/// cannot start.
Key randomKey();

}  // namespace coherency
