#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "common/wire/DatagramCodec.h"
#include "common/wire/Validity.h"
#include "tests/wire/GoldenPackets.h"

using namespace coherency;

namespace {

/// A session's end, with the golden keyframe.
struct End {
  explicit End(const SampleForm& form) : codec(form) { store.add(golden::keyframe()); }

  DatagramCodec codec;
  KeyframeStore store;
};

/// By the input's first byte.
End& end(std::uint8_t choice) {
  static End ends[]{End{SampleForm{}}, End{golden::codes()}, End{golden::headOnly()}};
  return ends[choice % std::size(ends)];
}

template <class T>
void write(End& end, const T& value, std::vector<std::byte>& out) {
  if constexpr (std::is_same_v<T, MotionPacket>) {
    end.codec.encode(value, *end.store.find(value.keyframe), out);
  } else {
    end.codec.encode(value, out);
  }
}

/// What was accepted must be possible, and must survive being sent on.
template <class T>
void check(End& end, const T& value) {
  if (!isValid(value)) std::abort();
  std::vector<std::byte> bytes;
  write(end, value, bytes);
  const DecodedDatagram again = end.codec.decode(bytes, end.store);
  if (!std::holds_alternative<T>(again) || !(std::get<T>(again) == value)) std::abort();
}
void check(End&, Reject) {}

}  // namespace

/// The first byte chooses the session's form; the rest is a datagram's body.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  End& receiver = end(data[0]);
  const DecodedDatagram decoded =
      receiver.codec.decode(std::as_bytes(std::span(data, size)).subspan(1), receiver.store);
  std::visit([&](const auto& value) { check(receiver, value); }, decoded);
  return 0;
}
