#include "common/wire/Handshake.h"

#include <string_view>

#include <sodium.h>

#include "common/wire/Sodium.h"

namespace coherency {
namespace {

constexpr std::string_view kProtocol = "coherency 3";
constexpr char kContext[] = "coherncy";

static_assert(std::tuple_size_v<Key> == crypto_scalarmult_BYTES);
static_assert(std::tuple_size_v<Key> == crypto_scalarmult_SCALARBYTES);
static_assert(std::tuple_size_v<Key> == crypto_kdf_KEYBYTES);
static_assert(sizeof kContext - 1 == crypto_kdf_CONTEXTBYTES);

unsigned char* raw(std::byte* bytes) {
  return reinterpret_cast<unsigned char*>(bytes);
}
const unsigned char* raw(const std::byte* bytes) {
  return reinterpret_cast<const unsigned char*>(bytes);
}

/// BLAKE2b of 32 bytes, in pieces.
class Hash {
 public:
  explicit Hash(std::span<const std::byte> key = {}) {
    crypto_generichash_init(&state_, key.empty() ? nullptr : raw(key.data()), key.size(),
                            std::tuple_size_v<Key>);
  }
  ~Hash() { sodium_memzero(&state_, sizeof state_); }
  Hash& add(std::span<const std::byte> bytes) {
    crypto_generichash_update(&state_, raw(bytes.data()), bytes.size());
    return *this;
  }
  Key end() {
    Key out;
    crypto_generichash_final(&state_, raw(out.data()), out.size());
    return out;
  }

 private:
  crypto_generichash_state state_;
};

}  // namespace

Handshake::Handshake(const Key& secret) : secret_(secret) {
  requireSodium();
  crypto_scalarmult_base(raw(public_.data()), raw(secret_.data()));
}

Handshake::~Handshake() {
  sodium_memzero(secret_.data(), secret_.size());
}

std::optional<ConnectionKeys> Handshake::keys(const Key& other, const Key& preshared,
                                              std::span<const std::byte> client_opening,
                                              std::span<const std::byte> server_opening) const {
  Key shared;
  if (crypto_scalarmult(raw(shared.data()), raw(secret_.data()), raw(other.data())) != 0) return std::nullopt;
  Key master = Hash(preshared)
                   .add(std::as_bytes(std::span(kProtocol)))
                   .add(shared)
                   .add(Hash().add(client_opening).end())
                   .add(Hash().add(server_opening).end())
                   .end();
  ConnectionKeys keys;
  std::uint64_t id = 0;
  for (Key* key :
       {&keys.client_control, &keys.server_control, &keys.client_datagrams, &keys.server_datagrams}) {
    crypto_kdf_derive_from_key(raw(key->data()), key->size(), ++id, kContext, raw(master.data()));
  }
  sodium_memzero(shared.data(), shared.size());
  sodium_memzero(master.data(), master.size());
  return keys;
}

}  // namespace coherency
