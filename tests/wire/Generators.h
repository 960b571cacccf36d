#pragma once

#include "common/wire/Packets.h"
#include "common/wire/Validity.h"
#include "tests/world/Generators.h"

/// Arbitrary valid values of what motion consists of.
namespace coherency::arbitrary {

inline std::uint64_t id() {
  return *rc::gen::nonZero<std::uint64_t>();
}
inline std::int64_t timeNs() {
  return *rc::gen::inRange<std::int64_t>(0, kMaxTimeNs + 1);
}

/// Every integer unit from one end of the DOF's range to the other.
inline std::int32_t units(Dof dof) {
  const DofInfo& d = info(dof);
  const double fraction = *rc::gen::inRange(0, 1'000'001) * 1e-6;
  return unitsFromSi(d.kind, d.min + fraction * (d.max - d.min));
}

inline SampleForm form() {
  SampleForm f{*rc::gen::inRange<DofMask>(0, kAllDofs + 1), *rc::gen::arbitrary<bool>(), {}};
  for (std::size_t i = 0; i < kDofCount; ++i) f.still[i] = units(dofAt(i));
  return f;
}

/// As a session of that form has it.
inline MotionSample sample(std::uint64_t sequence, const SampleForm& form) {
  MotionSample s;
  s.sequence = sequence;
  s.server_time_ns = timeNs();
  s.device_time_us = *rc::gen::arbitrary<std::int64_t>();
  s.valid = *rc::gen::inRange<DofMask>(0, kAllDofs + 1) & form.dofs;
  for (std::size_t i = 0; i < kDofCount; ++i)
    s.units[i] = s.isValid(dofAt(i)) ? units(dofAt(i)) : *rc::gen::arbitrary<std::int32_t>();
  if (form.compact) s = compacted(s);
  for (std::size_t i = 0; i < kDofCount; ++i)
    if ((form.dofs & mask(dofAt(i))) == 0) s.units[i] = form.still[i];
  return s;
}

/// Another state of the same world: of all that it consists of, some is otherwise.
inline WorldState changed(const WorldState& from) {
  const WorldState other = random::state();
  const auto chance = [] { return *rc::gen::inRange(0, 3) == 0; };
  WorldState to = from;
  to.tick += *rc::gen::element<std::uint64_t>(0, 1, 50, other.tick);
  if (chance()) to.mode = other.mode;
  if (chance()) to.master = other.master;
  if (chance()) to.robot.base.x_nm = other.robot.base.x_nm;
  if (chance()) to.closed_hands = other.closed_hands;
  if (chance()) to.task = other.task;
  for (std::size_t i = 0; i < std::min(to.movables.size(), other.movables.size()); ++i) {
    if (chance()) to.movables[i] = other.movables[i];
    if (chance()) to.movables[i].y_nm = other.movables[i].y_nm;
  }
  for (std::size_t i = 0; i < std::min(to.doors.size(), other.doors.size()); ++i)
    if (chance()) to.doors[i] = other.doors[i];
  return to;
}

inline Keyframe keyframe() {
  return {*rc::gen::nonZero<std::uint32_t>(), random::state()};
}

inline FrameState frame(std::uint64_t number, const WorldState& from, const SampleForm& form) {
  return {number, sample(id(), form), changed(from), *rc::gen::arbitrary<std::uint64_t>()};
}

/// Of the world that the keyframe is of.
inline MotionPacket motion(const Keyframe& keyframe, const SampleForm& form) {
  MotionPacket p;
  p.keyframe = keyframe.number;
  p.hash = *rc::gen::arbitrary<std::uint64_t>();
  p.world = changed(keyframe.world);
  const auto sequence = *rc::gen::inRange<std::uint64_t>(kMaxPrevious + 1, std::uint64_t{1} << 62);
  p.sample = sample(sequence, form);
  const auto previous = *rc::gen::inRange<std::uint64_t>(0, kMaxPrevious + 1);
  for (std::uint64_t i = 1; i <= previous; ++i) p.previous.push_back(sample(sequence - i, form));
  const auto frames = *rc::gen::inRange<std::uint64_t>(0, kMaxFrames + 1);
  const auto number = *rc::gen::inRange<std::uint64_t>(kMaxFrames, std::uint64_t{1} << 62);
  for (std::uint64_t i = 0; i < frames; ++i) p.frames.push_back(frame(number - i, p.world, form));
  return p;
}

/// Equal but for what may have had no room: the oldest previous samples, and then the oldest frames.
inline bool same(const MotionPacket& decoded, MotionPacket sent) {
  const bool frames_whole = decoded.frames.size() == sent.frames.size();
  if (decoded.previous.size() > sent.previous.size() || decoded.frames.size() > sent.frames.size() ||
      (!frames_whole && !decoded.previous.empty()))
    return false;
  sent.previous.resize(decoded.previous.size());
  sent.frames.resize(decoded.frames.size());
  return decoded == sent;
}

inline ClockProbe probe() {
  return {timeNs(), *rc::gen::arbitrary<std::uint32_t>(), static_cast<MotionWay>(*rc::gen::inRange(0, 3))};
}
inline ClockReply reply() {
  const std::int64_t received = timeNs();
  return {timeNs(), received, *rc::gen::inRange<std::int64_t>(received, kMaxTimeNs + 1)};
}

}  // namespace coherency::arbitrary
