#include "common/wire/SealedDatagram.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "common/wire/Sodium.h"

namespace coherency {
namespace {

constexpr std::array<std::byte, 4> kPrefix{std::byte{'C'}, std::byte{'O'}, std::byte{'H'},
                                           std::byte{kSealedMajor}};
constexpr std::size_t kMagic = 3;  // of kPrefix: the same in every version
constexpr std::size_t kCounter = 8;
static_assert(kPrefix.size() + sizeof(std::uint32_t) + sizeof(std::uint64_t) == kSealedHeader);

}  // namespace

std::variant<Reject, DatagramHeader> readHeader(std::span<const std::byte> datagram) {
  if (datagram.size() > kMaxDatagram) return Reject::Oversized;
  if (datagram.size() < kPrefix.size() ||
      !std::equal(kPrefix.begin(), kPrefix.begin() + kMagic, datagram.begin())) {
    return Reject::Malformed;
  }
  if (datagram[kMagic] != kPrefix[kMagic]) return Reject::Version;
  if (datagram.size() < kSealedHeader + kSealTag) return Reject::Malformed;
  return DatagramHeader{static_cast<std::uint32_t>(readBigEndian(datagram.subspan(kPrefix.size(), 4))),
                        readBigEndian(datagram.subspan(kCounter, 8))};
}

DatagramSealer::DatagramSealer(const Key& key, std::uint32_t channel) : key_(key), channel_(channel) {
  requireSodium();
}

void DatagramSealer::begin(std::vector<std::byte>& out) const {
  out.resize(kSealedHeader);
}

void DatagramSealer::seal(std::vector<std::byte>& datagram) {
  assert(datagram.size() >= kSealedHeader && datagram.size() + kSealTag <= kMaxDatagram);
  ++counter_;
  datagram.resize(datagram.size() + kSealTag);
  const auto whole = std::span(datagram);
  std::copy(kPrefix.begin(), kPrefix.end(), datagram.begin());
  writeBigEndian(channel_, whole.subspan(kPrefix.size(), 4));
  writeBigEndian(counter_, whole.subspan(kCounter, 8));
  encrypt(key_, nonceOf(channel_, counter_), whole.first(kSealedHeader),
          whole.subspan(kSealedHeader, whole.size() - kSealedHeader - kSealTag), whole.last<kSealTag>());
}

DatagramOpener::DatagramOpener(const Key& key, std::uint32_t channel) : key_(key), channel_(channel) {
  requireSodium();
}

std::variant<Reject, std::span<const std::byte>> DatagramOpener::open(std::span<std::byte> datagram) {
  const auto read = readHeader(datagram);
  if (const Reject* reject = std::get_if<Reject>(&read)) return *reject;
  const auto& header = std::get<DatagramHeader>(read);
  const auto body = datagram.subspan(kSealedHeader, datagram.size() - kSealedHeader - kSealTag);
  // Authenticated first, the window second: a counter means nothing before it is known to be the sender's.
  if (header.channel != channel_ ||
      !decrypt(key_, nonceOf(header.channel, header.counter), datagram.first(kSealedHeader), body,
               datagram.last<kSealTag>())) {
    return Reject::Forged;
  }
  if (!window_.fresh(header.counter)) return Reject::Replayed;
  window_.take(header.counter);
  return body;
}

}  // namespace coherency
