#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "common/wire/Packets.h"

namespace coherency {

/// First of all, in the clear, from each side. Of another major version nothing but the number counts.
struct Hello {
  std::uint32_t major = kWireMajor;
  std::uint32_t minor = kWireMinor;
  Key public_key{};    ///< X25519, of this connection alone
  bool keyed = false;  ///< has a key that both must have
  bool operator==(const Hello&) const = default;
};

/// Client to server, sealed as all that follows.
struct Join {
  std::string eye;       ///< "left", "right", "both" or "mono"
  std::string software;  ///< name and version, for people
  bool operator==(const Join&) const = default;
};

/// Client to server: say the keyframes again, as a state did not have the hash it should.
struct KeyframeRequest {
  bool operator==(const KeyframeRequest&) const = default;
};

/// What became of a frame at one eye.
enum class Fate : std::uint8_t {
  Drawn,
  InputLate,    ///< left out: nothing of it had come by its time
  DrawingLate,  ///< left out: the picture before it was not done
  Mismatch,     ///< left out: the state did not have its hash
};

/// The server certifies by these that the eyes agree, and fits its schedule to what they need.
struct FrameReport {
  std::uint64_t number = 0;
  Fate fate = Fate::Drawn;
  std::uint64_t tick = 0;  ///< of the state drawn
  std::uint64_t hash = 0;  ///< of the state drawn, as computed there
  std::int64_t presented_server_ns = 0;
  std::int64_t arrived_server_ns = 0;  ///< when it first came; 0: it has not
  std::int64_t draw_ns = 0;            ///< what its picture took, without waiting
  bool operator==(const FrameReport&) const = default;
};
struct ClientReport {
  std::vector<FrameReport> frames;  ///< since the last report, by rising number
  std::uint64_t packets_received = 0;
  std::uint64_t packets_lost = 0;
  bool operator==(const ClientReport&) const = default;
};

/// Client to server: whom the operator wishes to be from the next tick on.
struct ModeRequest {
  Mode mode = Mode::Operator;
  bool operator==(const ModeRequest&) const = default;
};

/// A datagram's body that travels over TCP, either way, where UDP is blocked.
struct Tunnelled {
  std::vector<std::byte> body;
  bool operator==(const Tunnelled&) const = default;
};

/// Either way: why the connection ends.
enum class GoodbyeCause : std::uint8_t {
  Leaving,   ///< the program ends
  Version,   ///< another major version: coming again is useless
  Full,      ///< too many clients
  Protocol,  ///< something was sent that has no place here
  Key,       ///< one has no key, or another one: coming again is useless
};
struct Goodbye {
  std::string reason;  ///< one line for people
  GoodbyeCause cause = GoodbyeCause::Leaving;
  bool operator==(const Goodbye&) const = default;
};

}  // namespace coherency
