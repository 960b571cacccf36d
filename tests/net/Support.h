#pragma once

#include <vector>

#include "common/wire/ControlCodec.h"
#include "common/wire/ControlFraming.h"
#include "common/wire/DatagramCodec.h"

namespace coherency::testing {

using Bytes = std::vector<std::byte>;

template <class T>
Bytes datagram(const T& value) {
  Bytes bytes;
  DatagramCodec().encode(value, bytes);
  return bytes;
}

inline std::vector<DecodedControl> messagesIn(const Bytes& stream) {
  std::vector<DecodedControl> messages;
  ControlFraming framing;
  framing.feed(stream);
  while (const auto message = framing.next()) messages.push_back(decodeControl(*message));
  return messages;
}

inline SessionConfig laboratory() {
  SessionConfig session;
  session.scene.name = "laboratory";
  session.udp_port = 1;
  return session;
}

inline MotionPacket packet(std::uint64_t session_id, std::uint64_t sequence) {
  MotionPacket p;
  p.session_id = session_id;
  p.sample.sequence = sequence;
  p.world.tick = sequence;
  p.hash = stateHash(p.world, p.sample);
  return p;
}

}  // namespace coherency::testing
