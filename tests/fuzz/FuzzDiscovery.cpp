#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "common/wire/Discovery.h"
#include "common/wire/Validity.h"

using namespace coherency;

namespace {

template <class T>
void mustComeBack(const T& value) {
  const auto again = decodeDiscovery(encodeDiscovery(value));
  if (!std::holds_alternative<T>(again) || !(std::get<T>(again) == value)) std::abort();
}

void check(const Search& search, std::size_t size) {
  if (size < kSearchSize) std::abort();  // an answer would be more than was asked
  mustComeBack(search);
}
void check(const Announcement& announcement, std::size_t) {
  if (!isValid(announcement) || encodeDiscovery(announcement).size() > kSearchSize) std::abort();
  mustComeBack(announcement);
}
void check(Reject, std::size_t) {}

}  // namespace

/// The input is a whole datagram.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto decoded = decodeDiscovery(std::as_bytes(std::span(data, size)));
  std::visit([&](const auto& value) { check(value, size); }, decoded);
  return 0;
}
