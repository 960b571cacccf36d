#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "common/wire/KeyframeStore.h"
#include "common/wire/Packets.h"
#include "common/wire/Reject.h"

namespace coherency {

using DecodedDatagram = std::variant<Reject, MotionPacket, ClockProbe, ClockReply>;

/// Domain types <-> datagrams' bodies (docs/wire.md), which are sealed elsewhere (SealedDatagram.h). Keeps
/// its working memory, so that steady motion allocates nothing but a decoded packet's own vectors. One thread
/// each.
class DatagramCodec {
 public:
  /// `form`: the session's; what has no samples in it needs none.
  explicit DatagramCodec(const SampleForm& form = {});
  ~DatagramCodec();
  DatagramCodec(const DatagramCodec&) = delete;
  DatagramCodec& operator=(const DatagramCodec&) = delete;

  /// Appends the body. Preconditions: isValid() of what is given; `keyframe` is the packet's, and all samples
  /// have the session's form. What has no room in kMaxDatagramBody is left out: first the oldest of the
  /// previous samples, then the oldest frames.
  void encode(const MotionPacket& packet, const WorldState& keyframe, std::vector<std::byte>& out);
  void encode(const ClockProbe& probe, std::vector<std::byte>& out);
  void encode(const ClockReply& reply, std::vector<std::byte>& out);

  /// Any bytes; what comes out is valid. Reject::NoKeyframe: motion that counts from a keyframe that is not
  /// among these.
  DecodedDatagram decode(std::span<const std::byte> body, const KeyframeStore& keyframes);

 private:
  struct Memory;
  SampleForm form_;
  std::unique_ptr<Memory> memory_;
};

}  // namespace coherency
