#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "common/wire/ControlCodec.h"
#include "common/wire/ControlFraming.h"
#include "common/wire/Validity.h"

using namespace coherency;

namespace {

template <class T>
void check(const T& value) {
  if (!isValid(value)) std::abort();
  // Others than our own version are understood in part only.
  if constexpr (std::is_same_v<T, Hello>) {
    if (value.major != kWireMajor) return;
  }
  const std::vector<std::byte> frame = encodeControl(value);
  if (!std::holds_alternative<T>(decodeControl(std::span(frame).subspan(kControlPrefix)))) std::abort();
}
void check(Reject) {}

}  // namespace

/// The input is a TCP stream, which arrives in pieces of its first byte's size.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto stream = std::as_bytes(std::span(data, size));
  const std::size_t piece = size == 0 ? 1 : std::max<std::size_t>(1, data[0]);
  ControlFraming framing;
  for (std::size_t at = 0; at < size; at += piece) {
    framing.feed(stream.subspan(at, std::min(piece, size - at)));
    while (const auto message = framing.next()) {
      std::visit([](const auto& value) { check(value); }, decodeControl(*message));
    }
  }
  return 0;
}
