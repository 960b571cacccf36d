#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace coherency {

/// Why something that reached a port was refused.
enum class Reject : std::uint8_t {
  Malformed,  ///< no packet of ours, or one with contents that cannot be
  Oversized,
  Version,   ///< ours, of another major version
  Forged,    ///< does not authenticate: of another key, another channel, or changed on the way
  Replayed,  ///< authentic, and here before or too old to know
};

/// Largest datagram: stays whole on every path of 1280 bytes MTU (IPv6's minimum) and leaves room for a seal.
inline constexpr std::size_t kMaxDatagram = 1200;
/// What precedes every datagram's body: "COH" and the major version.
inline constexpr std::size_t kEnvelopePrefix = 4;

/// The one place where a datagram is closed and opened. Begin with beginEnvelope(), append the body, then
/// seal().
void beginEnvelope(std::vector<std::byte>& out);
void seal(std::vector<std::byte>& datagram);
/// The body, which lies within `datagram`.
std::variant<Reject, std::span<const std::byte>> openEnvelope(std::span<const std::byte> datagram);

}  // namespace coherency
