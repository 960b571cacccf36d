#include "common/wire/WireState.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <type_traits>

#include "coherency.pb.h"

namespace coherency {
namespace {

void writeCodes(const MotionSample& sample, DofMask dofs, std::string& out) {
  out.clear();
  for (std::size_t i = 0; i < kDofCount; ++i) {
    if ((dofs & mask(dofAt(i))) == 0) continue;
    const std::uint16_t code = compactCode(dofAt(i), sample.units[i]);
    out.push_back(static_cast<char>(code & 0xff));
    out.push_back(static_cast<char>(code >> 8));
  }
}

std::size_t countOf(DofMask dofs) {
  return static_cast<std::size_t>(std::popcount(dofs));
}

std::uint16_t codeAt(const std::string& codes, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(codes[i]); };
  return static_cast<std::uint16_t>(byte(2 * at) | byte(2 * at + 1) << 8);
}

/// Differences wrap, so that any two numbers have one.
template <class Integer>
Integer difference(Integer to, Integer from) {
  using Bits = std::make_unsigned_t<Integer>;
  return static_cast<Integer>(static_cast<Bits>(to) - static_cast<Bits>(from));
}
template <class Integer>
Integer sum(Integer from, Integer difference) {
  using Bits = std::make_unsigned_t<Integer>;
  return static_cast<Integer>(static_cast<Bits>(from) + static_cast<Bits>(difference));
}

void writeDifference(const Vehicle& from, const Vehicle& to, wire::Vehicle& out) {
  wire::Base& base = *out.mutable_base();
  base.set_x_nm(difference(to.base.x_nm, from.base.x_nm));
  base.set_y_nm(difference(to.base.y_nm, from.base.y_nm));
  base.set_z_nm(difference(to.base.z_nm, from.base.z_nm));
  base.set_heading_units(difference(to.base.heading_units, from.base.heading_units));
  out.set_velocity_right_um(difference(to.velocity_right_um, from.velocity_right_um));
  out.set_velocity_ahead_um(difference(to.velocity_ahead_um, from.velocity_ahead_um));
  out.set_turn_rate_units(difference(to.turn_rate_units, from.turn_rate_units));
}

void readDifference(const wire::Vehicle& in, Vehicle& vehicle) {
  const wire::Base& base = in.base();
  vehicle.base.x_nm = sum(vehicle.base.x_nm, base.x_nm());
  vehicle.base.y_nm = sum(vehicle.base.y_nm, base.y_nm());
  vehicle.base.z_nm = sum(vehicle.base.z_nm, base.z_nm());
  vehicle.base.heading_units = sum(vehicle.base.heading_units, base.heading_units());
  vehicle.velocity_right_um = sum(vehicle.velocity_right_um, in.velocity_right_um());
  vehicle.velocity_ahead_um = sum(vehicle.velocity_ahead_um, in.velocity_ahead_um());
  vehicle.turn_rate_units = sum(vehicle.turn_rate_units, in.turn_rate_units());
}

void writeDifference(const Movable& from, const Movable& to, wire::Movable& out) {
  out.set_holder(static_cast<std::uint32_t>(to.holder));
  out.set_x_nm(difference(to.x_nm, from.x_nm));
  out.set_y_nm(difference(to.y_nm, from.y_nm));
  out.set_z_nm(difference(to.z_nm, from.z_nm));
  if (to.attitude != from.attitude) out.mutable_attitude()->Assign(to.attitude.begin(), to.attitude.end());
  out.set_fall_um(to.fall_um);
  out.set_resting(to.resting);
  out.set_unrest_us(to.unrest_us);
}

bool readDifference(const wire::Movable& in, Movable& movable) {
  const bool turned = in.attitude_size() != 0;
  if (in.holder() > static_cast<std::uint32_t>(Holder::RobotHand) ||
      (turned && in.attitude_size() != static_cast<int>(movable.attitude.size())))
    return false;
  movable.holder = static_cast<Holder>(in.holder());
  movable.x_nm = sum(movable.x_nm, in.x_nm());
  movable.y_nm = sum(movable.y_nm, in.y_nm());
  movable.z_nm = sum(movable.z_nm, in.z_nm());
  if (turned) std::copy(in.attitude().begin(), in.attitude().end(), movable.attitude.begin());
  movable.fall_um = in.fall_um();
  movable.resting = in.resting();
  movable.unrest_us = in.unrest_us();
  return true;
}

/// Whether a list names places there are, each once, in rising order.
template <class List>
bool namesPlaces(const List& list, std::size_t count) {
  std::int64_t before = -1;
  for (const auto& element : list) {
    if (static_cast<std::int64_t>(element.index()) <= before || element.index() >= count) return false;
    before = element.index();
  }
  return true;
}

}  // namespace

void write(const MotionSample& sample, const SampleForm& form, wire::Sample& out) {
  out.set_sequence(sample.sequence);
  out.set_server_time_ns(sample.server_time_ns);
  out.set_device_time_us(sample.device_time_us);
  out.set_valid(sample.valid);
  if (form.compact) return writeCodes(sample, form.dofs, *out.mutable_codes());
  out.mutable_units()->Clear();
  for (std::size_t i = 0; i < kDofCount; ++i)
    if ((form.dofs & mask(dofAt(i))) != 0) out.add_units(sample.units[i]);
}

bool read(const wire::Sample& in, const SampleForm& form, MotionSample& sample) {
  const std::size_t count = countOf(form.dofs);
  const auto units = static_cast<std::size_t>(in.units_size());
  if (form.compact ? in.codes().size() != 2 * count || units != 0 : units != count || !in.codes().empty())
    return false;
  sample.sequence = in.sequence();
  sample.server_time_ns = in.server_time_ns();
  sample.device_time_us = in.device_time_us();
  sample.valid = in.valid();
  std::size_t at = 0;
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const bool travels = (form.dofs & mask(dofAt(i))) != 0;
    sample.units[i] = !travels       ? form.still[i]
                      : form.compact ? unitsFromCode(dofAt(i), codeAt(in.codes(), at))
                                     : in.units(static_cast<int>(at));
    if (travels) ++at;
  }
  return (in.valid() & ~form.dofs) == 0;
}

void writeDifference(const WorldState& from, const WorldState& to, wire::World& out) {
  assert(from.movables.size() == to.movables.size() && from.doors.size() == to.doors.size());
  out.Clear();
  out.set_ticks(static_cast<std::int64_t>(to.tick - from.tick));
  out.set_mode(static_cast<std::uint32_t>(to.mode));
  out.set_closed_hands(to.closed_hands);
  if (to.master != from.master) writeDifference(from.master, to.master, *out.mutable_master());
  if (to.robot != from.robot) writeDifference(from.robot, to.robot, *out.mutable_robot());
  if (to.task != from.task) {
    out.mutable_task()->set_started_tick(to.task.started_tick);
    out.mutable_task()->set_done_tick(to.task.done_tick);
    out.mutable_task()->set_towers(to.task.towers);
    out.mutable_task()->set_standing(to.task.standing);
  }
  for (std::uint32_t i = 0; i < to.movables.size(); ++i) {
    if (to.movables[i] == from.movables[i]) continue;
    wire::Movable& movable = *out.add_movables();
    movable.set_index(i);
    writeDifference(from.movables[i], to.movables[i], movable);
  }
  for (std::uint32_t i = 0; i < to.doors.size(); ++i) {
    if (to.doors[i] == from.doors[i]) continue;
    wire::Door& door = *out.add_doors();
    door.set_index(i);
    door.set_open(to.doors[i]);
  }
}

bool readDifference(const WorldState& from, const wire::World& in, WorldState& to) {
  if (in.mode() > static_cast<std::uint32_t>(Mode::Robot) || in.closed_hands() > 3 ||
      !namesPlaces(in.movables(), from.movables.size()) || !namesPlaces(in.doors(), from.doors.size()))
    return false;
  to = from;
  to.tick += static_cast<std::uint64_t>(in.ticks());
  to.mode = static_cast<Mode>(in.mode());
  to.closed_hands = static_cast<std::uint8_t>(in.closed_hands());
  if (in.has_master()) readDifference(in.master(), to.master);
  if (in.has_robot()) readDifference(in.robot(), to.robot);
  if (in.has_task())
    to.task = {in.task().started_tick(), in.task().done_tick(), in.task().towers(), in.task().standing()};
  for (const wire::Movable& movable : in.movables())
    if (!readDifference(movable, to.movables[movable.index()])) return false;
  for (const wire::Door& door : in.doors()) to.doors[door.index()] = door.open();
  return true;
}

}  // namespace coherency
