#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/wire/Aead.h"
#include "common/wire/Key.h"

namespace coherency {

/// A sealed control message is kind | encrypted body | tag, 16 bytes. The nonce is four zeros and the
/// message's number in its direction, from 0, big-endian; the kind is authenticated. In the clear, without a
/// kind, go hellos, and goodbyes before there are keys: bytes of protobuf, of which none begins with 1.
inline constexpr std::byte kSealedMessage{1};

/// Seals what one side sends on one connection, in order. There are no copies: two sealers of one key would
/// use the same nonces.
class StreamSealer {
 public:
  explicit StreamSealer(const Key& key);
  StreamSealer(StreamSealer&&) = default;
  StreamSealer& operator=(StreamSealer&&) = default;

  /// Seals `message` from `body_start` to its end, of which the first byte is room for the kind, and appends
  /// the tag. What precedes is the frame's length, for finishControlFrame() afterwards.
  void seal(std::vector<std::byte>& message, std::size_t body_start);

 private:
  Key key_;
  std::uint64_t count_ = 0;
};

/// Opens what one side sends, in the order in which it was sealed.
class StreamOpener {
 public:
  explicit StreamOpener(const Key& key);

  /// `message` is as ControlFraming gives it, with its kind. Decrypts in place; the body lies within it.
  /// nullopt: forged, replayed, out of order, or in the clear. A connection that says such a thing has to
  /// end; the message's contents are spoilt then.
  std::optional<std::span<const std::byte>> open(std::span<std::byte> message);

 private:
  Key key_;
  std::uint64_t count_ = 0;
};

}  // namespace coherency
