#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "common/wire/Packets.h"
#include "common/wire/Reject.h"

namespace coherency {

/// What a server says of itself to whoever searches, in the clear and unproven: where to ask, not whom to
/// trust.
struct Announcement {
  std::uint32_t major = kWireMajor;
  std::uint32_t minor = kWireMinor;
  std::string host;  ///< the machine's name
  std::string scene;
  std::uint16_t port = 0;  ///< TCP and UDP
  bool keyed = false;      ///< wants a key
  std::uint32_t clients = 0;
  bool operator==(const Announcement&) const = default;
};

struct Search {
  std::uint32_t major = kWireMajor;
  bool operator==(const Search&) const = default;
};

/// A search is at least so long and an announcement no longer, so that nobody's searches under another's name
/// bring that one more than was sent.
inline constexpr std::size_t kSearchSize = 512;

/// Whole datagrams: "COH" and 0, then the message.
std::vector<std::byte> encodeDiscovery(const Search& search);
std::vector<std::byte> encodeDiscovery(const Announcement& announcement);
/// Any bytes; what comes out is valid. Other major versions come out too.
std::variant<Reject, Search, Announcement> decodeDiscovery(std::span<const std::byte> datagram);

}  // namespace coherency
