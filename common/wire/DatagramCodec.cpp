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

void write(const Vehicle& vehicle, wire::Vehicle& out) {
  wire::Base& base = *out.mutable_base();
  base.set_x_nm(vehicle.base.x_nm);
  base.set_y_nm(vehicle.base.y_nm);
  base.set_z_nm(vehicle.base.z_nm);
  base.set_heading_units(vehicle.base.heading_units);
  out.set_velocity_right_um(vehicle.velocity_right_um);
  out.set_velocity_ahead_um(vehicle.velocity_ahead_um);
  out.set_turn_rate_units(vehicle.turn_rate_units);
}

void write(const Movable& movable, wire::Movable& out) {
  out.set_holder(static_cast<std::uint32_t>(movable.holder));
  out.set_x_nm(movable.x_nm);
  out.set_y_nm(movable.y_nm);
  out.set_z_nm(movable.z_nm);
  out.mutable_attitude()->Assign(movable.attitude.begin(), movable.attitude.end());
  out.set_fall_um(movable.fall_um);
  out.set_resting(movable.resting);
  out.set_unrest_us(movable.unrest_us);
}

void write(const TaskClock& task, wire::Task& out) {
  out.set_started_tick(task.started_tick);
  out.set_done_tick(task.done_tick);
  out.set_towers(task.towers);
  out.set_standing(task.standing);
}

void write(const WorldState& world, wire::World& out) {
  out.set_tick(world.tick);
  out.set_mode(static_cast<std::uint32_t>(world.mode));
  write(world.master, *out.mutable_master());
  write(world.robot, *out.mutable_robot());
  out.set_closed_hands(world.closed_hands);
  out.mutable_movables()->Clear();
  for (const Movable& movable : world.movables) write(movable, *out.add_movables());
  out.mutable_doors()->Assign(world.doors.begin(), world.doors.end());
  write(world.task, *out.mutable_task());
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

Vehicle read(const wire::Vehicle& in) {
  const wire::Base& base = in.base();
  return {{base.x_nm(), base.y_nm(), base.z_nm(), base.heading_units()},
          in.velocity_right_um(),
          in.velocity_ahead_um(),
          in.turn_rate_units()};
}

bool read(const wire::Movable& in, Movable& movable) {
  if (in.holder() > static_cast<std::uint32_t>(Holder::RobotHand) ||
      in.attitude_size() != static_cast<int>(movable.attitude.size()))
    return false;
  movable.holder = static_cast<Holder>(in.holder());
  movable.x_nm = in.x_nm();
  movable.y_nm = in.y_nm();
  movable.z_nm = in.z_nm();
  std::copy(in.attitude().begin(), in.attitude().end(), movable.attitude.begin());
  movable.fall_um = in.fall_um();
  movable.resting = in.resting();
  movable.unrest_us = in.unrest_us();
  return true;
}

bool read(const wire::World& in, WorldState& world) {
  if (in.mode() > static_cast<std::uint32_t>(Mode::Robot) || in.closed_hands() > 3 ||
      in.movables_size() > static_cast<int>(kMaxMovables) || in.doors_size() > static_cast<int>(kMaxDoors))
    return false;
  world.tick = in.tick();
  world.mode = static_cast<Mode>(in.mode());
  world.master = read(in.master());
  world.robot = read(in.robot());
  world.closed_hands = static_cast<std::uint8_t>(in.closed_hands());
  for (const wire::Movable& movable : in.movables())
    if (!read(movable, world.movables.emplace_back())) return false;
  world.doors.assign(in.doors().begin(), in.doors().end());
  world.task = {in.task().started_tick(), in.task().done_tick(), in.task().towers(), in.task().standing()};
  return true;
}

DecodedDatagram read(const wire::Motion& in) {
  MotionPacket packet;
  packet.session_id = in.session_id();
  packet.hash = in.hash();
  // A World with every field zero is empty on the wire but there all the same.
  if (!in.has_world() || !in.has_sample() || !read(in.sample(), packet.sample) ||
      !read(in.world(), packet.world))
    return Reject::Malformed;
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
  // The state comes first: where a world is large, fewer of the samples before fit beside it.
  while (memory_->motion.ByteSizeLong() + kEnvelopePrefix > kMaxDatagram)
    motion.mutable_previous()->RemoveLast();
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
