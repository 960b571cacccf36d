#include "common/wire/Aead.h"

#include <sodium.h>

namespace coherency {
namespace {

static_assert(std::tuple_size_v<Key> == crypto_aead_chacha20poly1305_ietf_KEYBYTES);
static_assert(std::tuple_size_v<Nonce> == crypto_aead_chacha20poly1305_ietf_NPUBBYTES);
static_assert(kSealTag == crypto_aead_chacha20poly1305_ietf_ABYTES);

unsigned char* raw(std::byte* bytes) {
  return reinterpret_cast<unsigned char*>(bytes);
}
const unsigned char* raw(const std::byte* bytes) {
  return reinterpret_cast<const unsigned char*>(bytes);
}

}  // namespace

Nonce nonceOf(std::uint32_t channel, std::uint64_t counter) {
  Nonce nonce;
  writeBigEndian(channel, std::span(nonce).first(sizeof channel));
  writeBigEndian(counter, std::span(nonce).subspan(sizeof channel));
  return nonce;
}

void encrypt(const Key& key, const Nonce& nonce, std::span<const std::byte> header, std::span<std::byte> body,
             std::span<std::byte, kSealTag> tag) {
  crypto_aead_chacha20poly1305_ietf_encrypt_detached(
      raw(body.data()), raw(tag.data()), nullptr, raw(body.data()), body.size(), raw(header.data()),
      header.size(), nullptr, raw(nonce.data()), raw(key.data()));
}

bool decrypt(const Key& key, const Nonce& nonce, std::span<const std::byte> header, std::span<std::byte> body,
             std::span<const std::byte, kSealTag> tag) {
  return crypto_aead_chacha20poly1305_ietf_decrypt_detached(
             raw(body.data()), nullptr, raw(body.data()), body.size(), raw(tag.data()), raw(header.data()),
             header.size(), raw(nonce.data()), raw(key.data())) == 0;
}

void writeBigEndian(std::uint64_t value, std::span<std::byte> out) {
  for (std::size_t i = out.size(); i > 0; --i, value >>= 8) out[i - 1] = static_cast<std::byte>(value);
}

std::uint64_t readBigEndian(std::span<const std::byte> in) {
  std::uint64_t value = 0;
  for (const std::byte b : in) value = value << 8 | std::to_integer<std::uint64_t>(b);
  return value;
}

}  // namespace coherency
