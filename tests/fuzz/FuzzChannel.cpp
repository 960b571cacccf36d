#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "common/wire/ControlChannel.h"
#include "common/wire/Validity.h"
#include "tests/wire/SealSupport.h"

using namespace coherency;

namespace {

ControlChannel newServer() {
  return {ControlChannel::Side::Server, sealing::countingKey(64), sealing::countingKey(32)};
}

/// As a server reacts. False: the connection ends.
bool react(ControlChannel& server, const DecodedControl& decoded) {
  const auto* const message = std::get_if<ControlMessage>(&decoded);
  if (message == nullptr) return false;
  const auto* const hello = std::get_if<Hello>(message);
  if (hello == nullptr) {
    // Before the proof nothing but a Goodbye is understood, whatever the bytes.
    if (!server.proven() && !std::holds_alternative<Goodbye>(*message)) std::abort();
    return !std::holds_alternative<Goodbye>(*message);
  }
  std::vector<std::byte> answer;
  if (hello->major != kWireMajor) {
    server.write(Goodbye{"another version", GoodbyeCause::Version}, answer);
    return false;
  }
  server.write(server.hello(), answer);
  return server.agree(*hello);
}

}  // namespace

/// The input is a TCP stream, which arrives in pieces of its first byte's size. There are seeds in which the
/// client knows the key: of what follows their hello, only what they sealed may be understood.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto stream = std::as_bytes(std::span(data, size)).subspan(1);
  const std::size_t piece = std::max<std::size_t>(1, data[0]);
  ControlChannel server = newServer();
  for (std::size_t at = 0; at < stream.size(); at += piece) {
    server.feed(stream.subspan(at, std::min(piece, stream.size() - at)));
    while (const auto decoded = server.next())
      if (!react(server, *decoded)) return 0;
    if (server.oversized()) return 0;
  }
  return 0;
}
