#include "common/wire/Discovery.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "coherency.pb.h"

#include "common/wire/Validity.h"

namespace coherency {
namespace {

constexpr std::array<std::byte, 4> kPrefix{std::byte{'C'}, std::byte{'O'}, std::byte{'H'}, std::byte{0}};

std::vector<std::byte> encode(const wire::Discovery& message) {
  std::vector<std::byte> out(kPrefix.begin(), kPrefix.end());
  const std::size_t size = message.ByteSizeLong();
  out.resize(kPrefix.size() + size);
  message.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(out.data() + kPrefix.size()));
  return out;
}

}  // namespace

std::vector<std::byte> encodeDiscovery(const Search& search) {
  wire::Discovery message;
  message.mutable_search()->set_major(search.major);
  message.mutable_search()->set_padding(std::string(kSearchSize, '\0'));
  return encode(message);
}

std::vector<std::byte> encodeDiscovery(const Announcement& announcement) {
  assert(isValid(announcement));
  wire::Discovery message;
  wire::Announcement& out = *message.mutable_announcement();
  out.set_major(announcement.major);
  out.set_minor(announcement.minor);
  out.set_host(announcement.host);
  out.set_scene(announcement.scene);
  out.set_port(announcement.port);
  out.set_keyed(announcement.keyed);
  out.set_clients(announcement.clients);
  std::vector<std::byte> bytes = encode(message);
  assert(bytes.size() <= kSearchSize);
  return bytes;
}

std::variant<Reject, Search, Announcement> decodeDiscovery(std::span<const std::byte> datagram) {
  if (datagram.size() > kMaxDatagram) return Reject::Oversized;
  if (datagram.size() < kPrefix.size() || !std::equal(kPrefix.begin(), kPrefix.end(), datagram.begin()))
    return Reject::Malformed;
  const auto body = datagram.subspan(kPrefix.size());
  wire::Discovery message;
  if (!message.ParseFromArray(body.data(), static_cast<int>(body.size()))) return Reject::Malformed;
  if (message.has_search() && datagram.size() >= kSearchSize) return Search{message.search().major()};
  const wire::Announcement& in = message.announcement();
  if (!message.has_announcement() || in.port() > 65535) return Reject::Malformed;
  Announcement announcement{
      in.major(), in.minor(),  in.host(), in.scene(), static_cast<std::uint16_t>(in.port()),
      in.keyed(), in.clients()};
  if (!isValid(announcement)) return Reject::Malformed;
  return announcement;
}

}  // namespace coherency
