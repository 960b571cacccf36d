#include "common/wire/DatagramCodec.h"

#include <array>
#include <cassert>

#include "coherency.pb.h"
#include <google/protobuf/arena.h>

#include "common/wire/SealedDatagram.h"
#include "common/wire/Validity.h"
#include "common/wire/WireState.h"

namespace coherency {
namespace {

void write(const FrameState& frame, const SampleForm& form, const WorldState& from, wire::Frame& out) {
  out.set_number(frame.number);
  out.set_hash(frame.hash);
  write(frame.sample, form, *out.mutable_sample());
  writeDifference(from, frame.world, *out.mutable_world());
}

bool read(const wire::Frame& in, const SampleForm& form, const WorldState& from, FrameState& frame) {
  frame.number = in.number();
  frame.hash = in.hash();
  return in.has_world() && in.has_sample() && read(in.sample(), form, frame.sample) &&
         readDifference(from, in.world(), frame.world);
}

template <class List>
auto firstOf(const List& list, std::size_t limit) {
  return std::min(static_cast<std::size_t>(list.size()), limit);
}

DecodedDatagram read(const wire::Motion& in, const SampleForm& form, const KeyframeStore& keyframes) {
  const WorldState* const keyframe = keyframes.find(in.keyframe());
  if (keyframe == nullptr) return in.keyframe() == 0 ? Reject::Malformed : Reject::NoKeyframe;
  MotionPacket packet;
  packet.keyframe = in.keyframe();
  packet.hash = in.hash();
  // A World that differs in nothing is empty on the wire but there all the same.
  if (!in.has_world() || !in.has_sample() || !read(in.sample(), form, packet.sample) ||
      !readDifference(*keyframe, in.world(), packet.world))
    return Reject::Malformed;
  packet.previous.resize(firstOf(in.previous(), kMaxPrevious + 1));
  for (std::size_t i = 0; i < packet.previous.size(); ++i)
    if (!read(in.previous(static_cast<int>(i)), form, packet.previous[i])) return Reject::Malformed;
  packet.frames.resize(firstOf(in.frames(), kMaxFrames + 1));
  for (std::size_t i = 0; i < packet.frames.size(); ++i)
    if (!read(in.frames(static_cast<int>(i)), form, packet.world, packet.frames[i])) return Reject::Malformed;
  if (!isValid(packet)) return Reject::Malformed;
  return packet;
}

DecodedDatagram read(const wire::ClockProbe& in) {
  if (in.way() < 0 || in.way() > wire::TCP) return Reject::Malformed;
  const ClockProbe probe{in.t0_client_ns(), in.keyframe(), static_cast<MotionWay>(in.way())};
  if (!isValid(probe)) return Reject::Malformed;
  return probe;
}

DecodedDatagram read(const wire::ClockReply& in) {
  const ClockReply reply{in.t0_client_ns(), in.t1_server_ns(), in.t2_server_ns()};
  if (!isValid(reply)) return Reject::Malformed;
  return reply;
}

void serialize(const wire::Datagram& message, std::vector<std::byte>& out) {
  const std::size_t size = message.ByteSizeLong();
  const std::size_t start = out.size();
  assert(size <= kMaxDatagramBody);
  out.resize(start + size);
  message.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(out.data() + start));
}

/// The newest frame is what is drawn next: all else goes before it does.
void leaveOut(wire::Motion& motion) {
  if (motion.previous_size() > 0)
    motion.mutable_previous()->RemoveLast();
  else
    motion.mutable_frames()->RemoveLast();
}

}  // namespace

/// Motion keeps a message of its own, so that its repeated fields are reused; decoding works in an arena
/// whose first block holds any datagram of ours.
struct DatagramCodec::Memory {
  wire::Datagram motion;
  wire::Datagram other;
  std::array<char, 16384> block;
  google::protobuf::Arena arena{block.data(), block.size()};
};

DatagramCodec::DatagramCodec(const SampleForm& form) : form_(form), memory_(std::make_unique<Memory>()) {}
DatagramCodec::~DatagramCodec() = default;

void DatagramCodec::encode(const MotionPacket& packet, const WorldState& keyframe,
                           std::vector<std::byte>& out) {
  assert(isValid(packet));
  wire::Motion& motion = *memory_->motion.mutable_motion();
  motion.set_keyframe(packet.keyframe);
  motion.set_hash(packet.hash);
  write(packet.sample, form_, *motion.mutable_sample());
  writeDifference(keyframe, packet.world, *motion.mutable_world());
  motion.mutable_previous()->Clear();
  for (const MotionSample& sample : packet.previous) write(sample, form_, *motion.add_previous());
  motion.mutable_frames()->Clear();
  for (const FrameState& frame : packet.frames) write(frame, form_, packet.world, *motion.add_frames());
  while (memory_->motion.ByteSizeLong() > kMaxDatagramBody) leaveOut(motion);
  serialize(memory_->motion, out);
}

void DatagramCodec::encode(const ClockProbe& probe, std::vector<std::byte>& out) {
  assert(isValid(probe));
  wire::ClockProbe& message = *memory_->other.mutable_clock_probe();
  message.set_t0_client_ns(probe.t0_client_ns);
  message.set_keyframe(probe.keyframe);
  message.set_way(static_cast<wire::Way>(probe.way));
  serialize(memory_->other, out);
}

void DatagramCodec::encode(const ClockReply& reply, std::vector<std::byte>& out) {
  assert(isValid(reply));
  wire::ClockReply& message = *memory_->other.mutable_clock_reply();
  message.set_t0_client_ns(reply.t0_client_ns);
  message.set_t1_server_ns(reply.t1_server_ns);
  message.set_t2_server_ns(reply.t2_server_ns);
  serialize(memory_->other, out);
}

DecodedDatagram DatagramCodec::decode(std::span<const std::byte> body, const KeyframeStore& keyframes) {
  if (body.size() > kMaxDatagramBody) return Reject::Oversized;
  memory_->arena.Reset();
  auto& message = *google::protobuf::Arena::CreateMessage<wire::Datagram>(&memory_->arena);
  if (!message.ParseFromArray(body.data(), static_cast<int>(body.size()))) return Reject::Malformed;
  switch (message.body_case()) {
    case wire::Datagram::kMotion:
      return read(message.motion(), form_, keyframes);
    case wire::Datagram::kClockProbe:
      return read(message.clock_probe());
    case wire::Datagram::kClockReply:
      return read(message.clock_reply());
    case wire::Datagram::BODY_NOT_SET:
      break;
  }
  return Reject::Malformed;
}

}  // namespace coherency
