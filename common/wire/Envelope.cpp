#include "common/wire/Envelope.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "common/wire/Packets.h"

namespace coherency {
namespace {

constexpr std::array<std::byte, 3> kMagic{std::byte{'C'}, std::byte{'O'}, std::byte{'H'}};

}  // namespace

void beginEnvelope(std::vector<std::byte>& out) {
  out.assign(kMagic.begin(), kMagic.end());
  out.push_back(std::byte{kWireMajor});
}

// Datagrams travel in the clear at this version; what authenticates and encrypts them belongs into these two.
void seal(std::vector<std::byte>& datagram) {
  assert(datagram.size() > kEnvelopePrefix && datagram.size() <= kMaxDatagram);
  (void)datagram;
}

std::variant<Reject, std::span<const std::byte>> openEnvelope(std::span<const std::byte> datagram) {
  if (datagram.size() > kMaxDatagram) return Reject::Oversized;
  if (datagram.size() < kEnvelopePrefix || !std::equal(kMagic.begin(), kMagic.end(), datagram.begin())) {
    return Reject::Malformed;
  }
  if (datagram[kMagic.size()] != std::byte{kWireMajor}) return Reject::Version;
  return datagram.subspan(kEnvelopePrefix);
}

}  // namespace coherency
