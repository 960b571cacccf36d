#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Protobuf's wire format by hand: for messages that no encoder of ours makes.
namespace coherency::protobuf {

inline std::string varint(std::uint64_t value) {
  std::string out;
  for (; value >= 0x80; value >>= 7) out.push_back(static_cast<char>((value & 0x7f) | 0x80));
  out.push_back(static_cast<char>(value));
  return out;
}
inline std::string field(std::uint32_t number, std::uint64_t value) {
  return varint(number << 3) + varint(value);
}
inline std::string field(std::uint32_t number, const std::string& bytes) {
  return varint(number << 3 | 2) + varint(bytes.size()) + bytes;
}

inline std::vector<std::byte> bytes(const std::string& message) {
  const auto* const first = reinterpret_cast<const std::byte*>(message.data());
  return {first, first + message.size()};
}

/// What a newer minor version adds, to a message and to the body it has in its one field.
inline std::string unknownField() {
  return field(99, 5) + field(100, "new");
}
inline std::vector<std::byte> withUnknownFields(const std::vector<std::byte>& message) {
  const std::string text(reinterpret_cast<const char*>(message.data()), message.size());
  std::size_t header = 2;  // the field's tag, and its length
  while ((static_cast<unsigned char>(text[header - 1]) & 0x80) != 0) ++header;
  const auto number = static_cast<unsigned char>(text[0]) >> 3;
  return bytes(field(static_cast<std::uint32_t>(number), text.substr(header) + unknownField()) +
               unknownField());
}

}  // namespace coherency::protobuf
