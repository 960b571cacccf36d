#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "common/wire/DatagramCodec.h"
#include "common/wire/Validity.h"

using namespace coherency;

namespace {

DatagramCodec& codec() {
  static DatagramCodec one;
  return one;
}

/// What was accepted must be possible, and must survive being sent on.
template <class T>
void check(const T& value) {
  if (!isValid(value)) std::abort();
  std::vector<std::byte> bytes;
  codec().encode(value, bytes);
  const DecodedDatagram again = codec().decode(bytes);
  if (!std::holds_alternative<T>(again) || !(std::get<T>(again) == value)) std::abort();
}
void check(Reject) {}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const DecodedDatagram decoded = codec().decode(std::as_bytes(std::span(data, size)));
  std::visit([](const auto& value) { check(value); }, decoded);
  return 0;
}
