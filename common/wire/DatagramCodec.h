#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "common/wire/Envelope.h"
#include "common/wire/Packets.h"

namespace coherency {

using DecodedDatagram = std::variant<Reject, MotionPacket, ClockProbe, ClockReply>;

/// Domain types <-> sealed datagrams (docs/wire.md). Keeps its working memory, so that steady motion
/// allocates nothing but a decoded packet's own vector. One thread each.
class DatagramCodec {
 public:
  DatagramCodec();
  ~DatagramCodec();
  DatagramCodec(const DatagramCodec&) = delete;
  DatagramCodec& operator=(const DatagramCodec&) = delete;

  /// Replaces what `out` held. Precondition: isValid() of what is given. Of a packet's previous samples as
  /// many are sent as fit into kMaxDatagram.
  void encode(const MotionPacket& packet, std::vector<std::byte>& out);
  void encode(const ClockProbe& probe, std::vector<std::byte>& out);
  void encode(const ClockReply& reply, std::vector<std::byte>& out);

  /// Any bytes; what comes out is valid.
  DecodedDatagram decode(std::span<const std::byte> datagram);

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace coherency
