#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "common/wire/ControlCodec.h"
#include "common/wire/ControlFraming.h"
#include "common/wire/Handshake.h"
#include "common/wire/SealedStream.h"

namespace coherency {

/// One end of a control connection, without its socket: bytes <-> messages, in the clear until both hellos
/// were said, sealed from there on (docs/wire.md).
///
///     client: write(hello())                    server: next() gives a Hello; write(hello()); agree(theirs)
///     client: next() gives a Hello; agree(theirs); write(Join) ...
class ControlChannel {
 public:
  enum class Side { Client, Server };

  /// `preshared`: kNoKey where there is none. `secret`: 32 random bytes for this connection alone.
  ControlChannel(Side side, const Key& preshared, const Key& secret);

  /// What this side says first.
  Hello hello() const;
  /// Both hellos having passed: from now on all is sealed. False: theirs holds no public key.
  bool agree(const Hello& theirs);
  /// The connection's keys. Precondition: agreed.
  const ConnectionKeys& keys() const;
  bool agreed() const { return keys_.has_value(); }
  /// The other side has shown that it has the same keys.
  bool proven() const { return proven_; }

  void feed(std::span<const std::byte> bytes) { framing_.feed(bytes); }
  /// The next whole message; nullopt when more bytes are needed. Reject::Forged: it is not sealed with this
  /// connection's keys; the connection has to end.
  std::optional<DecodedControl> next();
  bool oversized() const { return framing_.oversized(); }

  /// Appends the message as it goes into the stream. A server's Goodbye goes in the clear until the client
  /// has proven its keys, as it is likely to be about them. A client's is sealed as soon as there are keys:
  /// the server, who speaks second, may have the proof already.
  void write(const ControlMessage& message, std::vector<std::byte>& out);

 private:
  DecodedControl open(std::span<std::byte> message);
  DecodedControl readClear(std::span<const std::byte> message);
  bool isSealed(const ControlMessage& message) const;

  Side side_;
  Key preshared_;
  Handshake handshake_;
  ControlFraming framing_;
  std::vector<std::byte> own_hello_;
  std::vector<std::byte> their_hello_;
  std::optional<ConnectionKeys> keys_;
  std::optional<StreamSealer> sealer_;
  std::optional<StreamOpener> opener_;
  bool proven_ = false;
};

}  // namespace coherency
