#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "common/wire/Key.h"

namespace coherency {

inline constexpr std::size_t kSealTag = 16;  ///< bytes by which a sealed body is longer

/// ChaCha20-Poly1305 (RFC 8439), libsodium's crypto_aead_chacha20poly1305_ietf. A nonce may serve a key once.
using Nonce = std::array<std::byte, 12>;
/// The channel and the counter, big-endian.
Nonce nonceOf(std::uint32_t channel, std::uint64_t counter);

/// Encrypts `body` in place and writes the tag, which covers `header` too.
void encrypt(const Key& key, const Nonce& nonce, std::span<const std::byte> header, std::span<std::byte> body,
             std::span<std::byte, kSealTag> tag);
/// Decrypts `body` in place; false where key, nonce, header, body and tag do not belong together, and the
/// body is zeros then.
bool decrypt(const Key& key, const Nonce& nonce, std::span<const std::byte> header, std::span<std::byte> body,
             std::span<const std::byte, kSealTag> tag);

/// The unsigned number of as many bytes, big-endian.
void writeBigEndian(std::uint64_t value, std::span<std::byte> out);
std::uint64_t readBigEndian(std::span<const std::byte> in);

}  // namespace coherency
