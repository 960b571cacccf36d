#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "common/wire/ControlCodec.h"
#include "common/wire/ControlFraming.h"
#include "common/wire/SealedStream.h"
#include "common/wire/Validity.h"

using namespace coherency;

namespace {

/// What was accepted must be possible, must survive being sent on, and must fit what it is sent in.
template <class T>
void check(const T& value) {
  if constexpr (std::is_same_v<T, Hello>) {
    if (value.major != kWireMajor) {
      if (!(value == Hello{value.major, value.minor, {}, false})) std::abort();
      return;
    }
  }
  if (!isValid(value)) std::abort();
  std::vector<std::byte> bytes;
  encodeControl(value, bytes);
  if (bytes.size() + 1 + kSealTag > kMaxControlMessage) std::abort();
  const DecodedControl again = decodeControl(bytes);
  const auto* const message = std::get_if<ControlMessage>(&again);
  if (message == nullptr || !std::holds_alternative<T>(*message)) std::abort();
  std::vector<std::byte> twice;
  encodeControl(*message, twice);
  if (twice != bytes) std::abort();
}

}  // namespace

/// The input is one message, opened.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const DecodedControl decoded = decodeControl(std::as_bytes(std::span(data, size)));
  if (const auto* const message = std::get_if<ControlMessage>(&decoded))
    std::visit([](const auto& value) { check(value); }, *message);
  return 0;
}
