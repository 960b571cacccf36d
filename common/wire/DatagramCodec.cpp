#include "common/wire/DatagramCodec.h"

#include <array>
#include <cassert>
#include <optional>

#include "coherency.pb.h"
#include <google/protobuf/arena.h>

#include "common/wire/Validity.h"

namespace coherency {
namespace {

void write(const MotionSample& sample, wire::Sample& out) {
  out.set_sequence(sample.sequence);
  out.set_server_time_ns(sample.server_time_ns);
  out.set_device_time_us(sample.device_time_us);
  out.set_valid(sample.valid);
  out.mutable_units()->Assign(sample.units.begin(), sample.units.end());
}

void write(const WorldState& world, wire::World& out) {
  out.set_tick(world.tick);
  out.set_base_x_nm(world.base.x_nm);
  out.set_base_y_nm(world.base.y_nm);
  out.set_base_z_nm(world.base.z_nm);
  out.set_heading_units(world.base.heading_units);
  out.set_velocity_right_um(world.velocity_right_um);
  out.set_velocity_ahead_um(world.velocity_ahead_um);
  out.set_turn_rate_units(world.turn_rate_units);
}

bool read(const wire::Sample& in, MotionSample& sample) {
  if (in.units_size() != static_cast<int>(kDofCount)) return false;
  sample.sequence = in.sequence();
  sample.server_time_ns = in.server_time_ns();
  sample.device_time_us = in.device_time_us();
  sample.valid = in.valid();
  std::copy(in.units().begin(), in.units().end(), sample.units.begin());
  return true;
}

WorldState read(const wire::World& in) {
  WorldState world;
  world.tick = in.tick();
  world.base = {in.base_x_nm(), in.base_y_nm(), in.base_z_nm(), in.heading_units()};
  world.velocity_right_um = in.velocity_right_um();
  world.velocity_ahead_um = in.velocity_ahead_um();
  world.turn_rate_units = in.turn_rate_units();
  return world;
}

DecodedDatagram read(const wire::Motion& in) {
  MotionPacket packet;
  packet.session_id = in.session_id();
  packet.hash = in.hash();
  // A World with every field zero is empty on the wire but there all the same.
  if (!in.has_world() || !in.has_sample() || !read(in.sample(), packet.sample)) return Reject::Malformed;
  packet.world = read(in.world());
  packet.previous.resize(std::min(static_cast<std::size_t>(in.previous_size()), kMaxPrevious + 1));
  for (std::size_t i = 0; i < packet.previous.size(); ++i) {
    if (!read(in.previous(static_cast<int>(i)), packet.previous[i])) return Reject::Malformed;
  }
  if (!isValid(packet)) return Reject::Malformed;
  return packet;
}

DecodedDatagram read(const wire::ClockProbe& in) {
  const ClockProbe probe{in.session_id(), in.client_id(), in.client_token(), in.t0_client_ns()};
  if (!isValid(probe)) return Reject::Malformed;
  return probe;
}

DecodedDatagram read(const wire::ClockReply& in) {
  const ClockReply reply{in.session_id(), in.t0_client_ns(), in.t1_server_ns(), in.t2_server_ns()};
  if (!isValid(reply)) return Reject::Malformed;
  return reply;
}

void serialize(const wire::Datagram& message, std::vector<std::byte>& out) {
  beginEnvelope(out);
  const std::size_t size = message.ByteSizeLong();
  out.resize(kEnvelopePrefix + size);
  message.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(out.data() + kEnvelopePrefix));
  seal(out);
}

}  // namespace

/// Motion keeps a message of its own, so that its repeated fields are reused; decoding works in an arena
/// whose first block holds any datagram of ours.
struct DatagramCodec::Memory {
  wire::Datagram motion;
  wire::Datagram other;
  std::array<char, 8192> block;
  google::protobuf::Arena arena{block.data(), block.size()};
};

DatagramCodec::DatagramCodec() : memory_(std::make_unique<Memory>()) {}
DatagramCodec::~DatagramCodec() = default;

void DatagramCodec::encode(const MotionPacket& packet, std::vector<std::byte>& out) {
  assert(isValid(packet));
  wire::Motion& motion = *memory_->motion.mutable_motion();
  motion.set_session_id(packet.session_id);
  motion.set_hash(packet.hash);
  write(packet.sample, *motion.mutable_sample());
  write(packet.world, *motion.mutable_world());
  motion.mutable_previous()->Clear();
  for (const MotionSample& sample : packet.previous) write(sample, *motion.add_previous());
  serialize(memory_->motion, out);
}

void DatagramCodec::encode(const ClockProbe& probe, std::vector<std::byte>& out) {
  assert(isValid(probe));
  wire::ClockProbe& message = *memory_->other.mutable_clock_probe();
  message.set_session_id(probe.session_id);
  message.set_client_id(probe.client_id);
  message.set_client_token(probe.client_token);
  message.set_t0_client_ns(probe.t0_client_ns);
  serialize(memory_->other, out);
}

void DatagramCodec::encode(const ClockReply& reply, std::vector<std::byte>& out) {
  assert(isValid(reply));
  wire::ClockReply& message = *memory_->other.mutable_clock_reply();
  message.set_session_id(reply.session_id);
  message.set_t0_client_ns(reply.t0_client_ns);
  message.set_t1_server_ns(reply.t1_server_ns);
  message.set_t2_server_ns(reply.t2_server_ns);
  serialize(memory_->other, out);
}

DecodedDatagram DatagramCodec::decode(std::span<const std::byte> datagram) {
  const auto opened = openEnvelope(datagram);
  if (const auto* reject = std::get_if<Reject>(&opened)) return *reject;
  const auto body = std::get<std::span<const std::byte>>(opened);
  memory_->arena.Reset();
  auto& message = *google::protobuf::Arena::CreateMessage<wire::Datagram>(&memory_->arena);
  if (!message.ParseFromArray(body.data(), static_cast<int>(body.size()))) return Reject::Malformed;
  switch (message.body_case()) {
    case wire::Datagram::kMotion:
      return read(message.motion());
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
