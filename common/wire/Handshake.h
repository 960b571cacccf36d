#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "common/wire/Key.h"

namespace coherency {

/// A connection's four keys, by who sends with them.
struct ConnectionKeys {
  Key client_control, server_control, client_datagrams, server_datagrams;
  bool operator==(const ConnectionKeys&) const = default;
};

/// One per connection and side: agrees on keys by ephemeral X25519 (RFC 7748), mixed with the pre-shared key
/// and bound to what was said before there were keys. What was recorded stays closed to who learns the
/// pre-shared key later. In libsodium's names, `||` joining bytes:
///
///     shared = crypto_scalarmult(own secret, other's public key)
///     master = crypto_generichash(32 bytes, key = pre-shared key, message = "coherency 3" || shared ||
///                                 crypto_generichash(32 bytes, client opening) ||
///                                 crypto_generichash(32 bytes, server opening))
///     key i  = crypto_kdf_derive_from_key(32 bytes, id i, context "coherncy", master), i = 1 to 4 in the
///              order of ConnectionKeys
///
/// crypto_generichash is BLAKE2b (RFC 7693); crypto_kdf is BLAKE2b of no message under the key, the salt
/// being the id and the personalisation the context, both filled up with zeros to 16 bytes, the id
/// little-endian. The openings have to contain both public keys. tests/wire/seal_reference.py does it a
/// second time.
class Handshake {
 public:
  /// `secret` is 32 random bytes for this connection alone (randomKey()), passed in for exact tests.
  explicit Handshake(const Key& secret);
  Handshake(Handshake&&) = default;
  Handshake& operator=(Handshake&&) = default;
  ~Handshake();  ///< forgets the secret

  const Key& publicKey() const { return public_; }

  /// Keys both ends have in common if and only if they have the same pre-shared key and saw the same two
  /// opening messages. nullopt: `other` is no public key, but one of the few from which all secrets make
  /// zero (RFC 7748, section 6.1).
  std::optional<ConnectionKeys> keys(const Key& other, const Key& preshared,
                                     std::span<const std::byte> client_opening,
                                     std::span<const std::byte> server_opening) const;

 private:
  Key secret_;
  Key public_;
};

}  // namespace coherency
