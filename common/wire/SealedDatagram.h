#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "common/wire/Aead.h"
#include "common/wire/Key.h"
#include "common/wire/Reject.h"
#include "common/wire/ReplayWindow.h"

namespace coherency {

/// A datagram: "COH" | major, 1 byte | channel, uint32 | counter, uint64 | encrypted body | tag, 16 bytes.
/// Numbers are big-endian, the header is authenticated, channel and counter are the nonce. kMaxDatagram is
/// the size of all of it.
inline constexpr std::size_t kSealedHeader = 16;
inline constexpr std::size_t kMaxDatagramBody = kMaxDatagram - kSealedHeader - kSealTag;
inline constexpr std::uint8_t kSealedMajor = 3;
inline constexpr std::uint32_t kMotionChannel = 0;  ///< motion, to everybody; the others are clients' ids

struct DatagramHeader {
  std::uint32_t channel =
      0;  ///< 0: motion, server to everybody under the session's key; n: client n, both ways
  std::uint64_t counter = 0;  ///< of its sender on its channel
  bool operator==(const DatagramHeader&) const = default;
};

/// What a datagram says of itself, to choose the opener by; nothing is authenticated yet. Malformed,
/// Oversized or Version.
std::variant<Reject, DatagramHeader> readHeader(std::span<const std::byte> datagram);

/// Seals what one sender sends on one channel. A key belongs to one sealer: two would use the same nonces,
/// which gives away what they send. So there are no copies of one.
class DatagramSealer {
 public:
  DatagramSealer(const Key& key, std::uint32_t channel);
  DatagramSealer(DatagramSealer&&) = default;
  DatagramSealer& operator=(DatagramSealer&&) = default;

  /// Leaves room for the header in `out`, which the body follows; then seal(). Allocates nothing where `out`
  /// has held a datagram before.
  void begin(std::vector<std::byte>& out) const;
  /// Header and body together are at most kMaxDatagram - kSealTag. Counters begin at 1.
  void seal(std::vector<std::byte>& datagram);

 private:
  Key key_;
  std::uint32_t channel_;
  std::uint64_t counter_ = 0;
};

/// Opens what one sender sends on one channel, each datagram once.
class DatagramOpener {
 public:
  DatagramOpener(const Key& key, std::uint32_t channel);

  /// Decrypts in place; the body lies within `datagram`. As readHeader(), and Forged: does not authenticate,
  /// or is of another channel; Replayed: genuine, but its counter was seen or is too old. What is forged
  /// never moves the window. The contents of what is refused are spoilt.
  std::variant<Reject, std::span<const std::byte>> open(std::span<std::byte> datagram);

 private:
  Key key_;
  std::uint32_t channel_;
  ReplayWindow window_;
};

}  // namespace coherency
