#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "common/wire/SealedDatagram.h"
#include "common/wire/SealedStream.h"

using namespace coherency;

namespace {

constexpr Key kKey{std::byte{1}, std::byte{2}, std::byte{3}};  // the corpus is sealed with it
constexpr std::uint32_t kChannel = 7;

void require(bool condition) {
  if (!condition) std::abort();
}

bool liesWithin(std::span<const std::byte> body, std::span<const std::byte> whole) {
  return body.data() >= whole.data() && body.data() + body.size() <= whole.data() + whole.size();
}

/// What opens is what a sealer would have made, and opens once.
void checkDatagram(std::span<const std::byte> input) {
  std::vector<std::byte> datagram(input.begin(), input.end());
  const auto header = readHeader(input);
  DatagramOpener opener(kKey, kChannel);
  const auto body = opener.open(datagram);
  if (const Reject* reject = std::get_if<Reject>(&header)) {
    require(std::get<Reject>(body) == *reject && *reject != Reject::Forged && *reject != Reject::Replayed);
    return;
  }
  if (std::holds_alternative<Reject>(body)) return;
  require(std::get<DatagramHeader>(header).channel == kChannel);
  const auto opened = std::get<std::span<const std::byte>>(body);
  require(liesWithin(opened, datagram) && opened.size() == input.size() - kSealedHeader - kSealTag);
  datagram.assign(input.begin(), input.end());
  require(std::get<Reject>(opener.open(datagram)) == Reject::Replayed);
}

void checkMessage(std::span<const std::byte> input) {
  std::vector<std::byte> message(input.begin(), input.end());
  StreamOpener opener(kKey);
  const auto body = opener.open(message);
  if (!body) return;
  require(liesWithin(*body, message) && body->size() == input.size() - 1 - kSealTag);
  std::vector<std::byte> again(1 + body->size());
  std::copy(body->begin(), body->end(), again.begin() + 1);
  StreamSealer(kKey).seal(again, 0);
  require(std::equal(again.begin(), again.end(), input.begin(), input.end()));
  message.assign(input.begin(), input.end());
  require(!opener.open(message));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto input = std::as_bytes(std::span(data, size));
  checkDatagram(input);
  checkMessage(input);
  return 0;
}
