#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <rapidcheck.h>

#include "common/wire/Key.h"

namespace coherency::sealing {

using Bytes = std::vector<std::byte>;

inline Bytes bytesOf(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}
inline std::string textOf(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
inline Bytes copyOf(std::span<const std::byte> bytes) {
  return {bytes.begin(), bytes.end()};
}

inline std::string hexOf(std::span<const std::byte> bytes) {
  std::string hex;
  for (const std::byte b : bytes) {
    hex += "0123456789abcdef"[std::to_integer<int>(b >> 4)];
    hex += "0123456789abcdef"[std::to_integer<int>(b & std::byte{15})];
  }
  return hex;
}
inline Key keyOfHex(std::string_view hex) {
  if (hex.size() != 2 * std::tuple_size_v<Key>) throw std::invalid_argument("64 digits are a key");
  Key key;
  for (std::size_t i = 0; i < key.size(); ++i) {
    key[i] = static_cast<std::byte>(std::stoi(std::string(hex.substr(2 * i, 2)), nullptr, 16));
  }
  return key;
}

/// first, first + 1, ...
inline Key countingKey(int first) {
  Key key;
  for (std::byte& b : key) b = static_cast<std::byte>(first++);
  return key;
}
inline Bytes flipped(Bytes bytes, std::size_t bit) {
  bytes[bit / 8] ^= std::byte{1} << (bit % 8);
  return bytes;
}

inline Bytes arbitraryBytes(std::size_t longest) {
  const auto size = *rc::gen::inRange<std::size_t>(0, longest + 1);
  const auto numbers =
      *rc::gen::container<std::vector<std::uint8_t>>(size, rc::gen::arbitrary<std::uint8_t>());
  return copyOf(std::as_bytes(std::span(numbers)));
}
inline Key arbitraryKey() {
  const auto numbers = *rc::gen::container<std::vector<std::uint8_t>>(std::tuple_size_v<Key>,
                                                                      rc::gen::arbitrary<std::uint8_t>());
  Key key;
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = std::byte{numbers[i]};
  return key;
}

}  // namespace coherency::sealing
