#pragma once

namespace coherency {

/// Before the first use of libsodium, from any thread, as often as one likes. Throws std::runtime_error where
/// it cannot start.
void requireSodium();

}  // namespace coherency
