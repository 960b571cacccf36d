#pragma once

#include <vector>

#include "common/wire/ControlChannel.h"
#include "common/wire/DatagramCodec.h"
#include "common/wire/SealedDatagram.h"

namespace coherency::testing {

using Bytes = std::vector<std::byte>;

inline Key keyOf(int number) {
  Key key{};
  key[4] = static_cast<std::byte>(number);  // X25519 takes no heed of the lowest bits
  key[5] = static_cast<std::byte>(number >> 8);
  key[31] = std::byte{7};
  return key;
}

/// As a message goes into the stream before there are keys, whatever it is.
inline Bytes inTheClear(const ControlMessage& message) {
  Bytes bytes(kControlPrefix);
  encodeControl(message, bytes);
  finishControlFrame(bytes, 0);
  return bytes;
}

template <class T>
Bytes bodyOf(const T& value) {
  Bytes bytes;
  DatagramCodec().encode(value, bytes);
  return bytes;
}

inline Bytes sealed(DatagramSealer& sealer, const Bytes& body) {
  Bytes bytes;
  sealer.begin(bytes);
  bytes.insert(bytes.end(), body.begin(), body.end());
  sealer.seal(bytes);
  return bytes;
}

/// A client's end of the wire without sockets.
class WireClient {
 public:
  explicit WireClient(const Key& key = kNoKey, int secret = 1)
      : channel_(ControlChannel::Side::Client, key, keyOf(secret)) {}

  Bytes say(const ControlMessage& message) {
    Bytes bytes;
    channel_.write(message, bytes);
    return bytes;
  }
  Bytes hello() { return say(channel_.hello()); }

  /// What the server says. A hello is agreed to, and with a welcome there are datagrams.
  std::vector<DecodedControl> hear(const Bytes& stream) {
    std::vector<DecodedControl> heard;
    channel_.feed(stream);
    while (const auto next = channel_.next()) {
      heard.push_back(*next);
      const auto* const message = std::get_if<ControlMessage>(&*next);
      if (message == nullptr) continue;
      if (const auto* const hello = std::get_if<Hello>(message)) channel_.agree(*hello);
      if (const auto* const session = std::get_if<SessionConfig>(message)) welcomed(*session);
    }
    return heard;
  }

  Bytes datagram(const ClockProbe& probe) { return sealed(*sealer_, bodyOf(probe)); }
  DatagramOpener& opener() { return *opener_; }
  const ConnectionKeys& keys() const { return channel_.keys(); }
  const SessionConfig& session() const { return *session_; }
  std::uint32_t id() const { return session_->client_id; }

 private:
  void welcomed(const SessionConfig& session) {
    session_ = session;
    sealer_.emplace(channel_.keys().client_datagrams, session.client_id);
    opener_.emplace(channel_.keys().server_datagrams, session.client_id);
  }

  ControlChannel channel_;
  std::optional<SessionConfig> session_;
  std::optional<DatagramSealer> sealer_;
  std::optional<DatagramOpener> opener_;
};

template <class Message>
const Message& as(const DecodedControl& decoded) {
  return std::get<Message>(std::get<ControlMessage>(decoded));
}

inline SessionConfig laboratory() {
  SessionConfig session;
  session.scene.name = "laboratory";
  session.udp_port = 1;
  return session;
}

/// A world with two things in it that seldom change.
inline WorldState worldAt(std::uint64_t tick) {
  WorldState world;
  world.tick = tick;
  world.movables.resize(2);
  world.movables[1].x_nm = 500'000'000;
  world.doors.push_back(0);
  return world;
}

inline FrameState frameOf(std::uint64_t number, std::uint64_t sequence, std::int64_t photons_ns,
                          const WorldState& world) {
  FrameState frame;
  frame.number = number;
  frame.sample.sequence = sequence;
  frame.sample.server_time_ns = photons_ns;
  frame.world = world;
  frame.hash = stateHash(frame.world, frame.sample);
  return frame;
}

/// With a frame of its own number.
inline MotionPacket packet(std::uint64_t sequence, const WorldState& world) {
  MotionPacket p;
  p.keyframe = 1;
  p.sample.sequence = sequence;
  p.sample.server_time_ns = static_cast<std::int64_t>(sequence) * 1'000'000;
  p.world = world;
  p.hash = stateHash(p.world, p.sample);
  p.frames.push_back(frameOf(sequence, sequence, p.sample.server_time_ns + 16'000'000, world));
  return p;
}
inline MotionPacket packet(std::uint64_t sequence) {
  return packet(sequence, worldAt(sequence));
}

}  // namespace coherency::testing
