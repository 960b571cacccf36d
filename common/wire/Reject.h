#pragma once

#include <cstddef>
#include <cstdint>

namespace coherency {

/// Why something that reached a port was refused.
enum class Reject : std::uint8_t {
  Malformed,  ///< no packet of ours, or one with contents that cannot be
  Oversized,
  Version,     ///< ours, of another major version
  Forged,      ///< does not authenticate: of another key, another channel, or changed on the way
  Replayed,    ///< authentic, and here before or too old to know
  NoKeyframe,  ///< motion that counts from a keyframe which has not come yet
};

/// Largest datagram: stays whole on every path of 1280 bytes MTU (IPv6's minimum).
inline constexpr std::size_t kMaxDatagram = 1200;

}  // namespace coherency
