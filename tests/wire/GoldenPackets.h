#pragma once

#include "common/wire/Packets.h"

/// What motion consists of, one of each kind, chosen so that every field shows. The bytes are frozen: see
/// GoldenBytesTest.cpp.
namespace coherency::golden {

inline MotionSample sample(std::uint64_t sequence) {
  MotionSample s;
  s.sequence = sequence;
  s.server_time_ns = 1'000'000'000'000 + static_cast<std::int64_t>(sequence) * 1'000'000;
  s.device_time_us = static_cast<std::int64_t>(sequence) * 1000 - 7;
  s.valid = kAllDofs & ~mask(Dof::Grip);
  for (std::size_t i = 0; i < kDofCount; ++i)
    s.units[i] = static_cast<std::int32_t>(i) * 10'007 + static_cast<std::int32_t>(sequence);
  // The head is on the body: its height must be one that can be.
  s.units[index(Dof::HeadY)] = 1'180'000;
  return s;
}

inline Keyframe keyframe() {
  Keyframe k{3, {}};
  k.world.tick = 900;
  k.world.master.base = {1'000'000'000, 0, -500'000'000, -900'000};
  k.world.robot = {{-5'000'000, 7, 9, 1 << 30}, 1, -2, 3};
  for (const std::int64_t x : {100'000'000, 200'000'000, 300'000'000})
    k.world.movables.push_back({Holder::Nobody, x, 747'500'000, -987'654'321});
  k.world.doors = {0, kDoorOpen, 77};
  k.world.task = {17, 0, 0, false};
  return k;
}

/// What differs from the keyframe: a cube in the robot's hand, one that falls, one that stayed; the master
/// drives; a door closes; a tower was built.
inline WorldState world() {
  WorldState w = keyframe().world;
  w.tick = 1002;
  w.mode = Mode::Robot;
  w.master = {{1'234'567'890'123, 0, -987'654'321, -1'000'000}, 250'000, -800'000, 65'536};
  w.closed_hands = 2;
  w.movables[0] = {Holder::RobotHand, 1'000'000, -2'000'000, 3'000'000, {1 << 29, 1 << 29, 1 << 29, 1 << 29}};
  w.movables[2].y_nm = 747'000'000;
  w.movables[2].fall_um = 9807;
  w.movables[2].resting = false;
  w.movables[2].unrest_us = 5;
  w.doors[1] = kDoorOpen / 2;
  w.task = {17, 950, 1, true};
  return w;
}

inline FrameState frame(std::uint64_t number) {
  FrameState f{number, sample(1002 + number), world(), 0xb1c2d3e4f5061728 + number};
  f.world.tick += number;
  f.world.master.base.z_nm -= 1'000'000;
  f.world.movables[2].y_nm -= 10'000;
  f.world.doors[2] = 78;
  return f;
}

inline MotionPacket motion() {
  return {3, sample(1002), world(), 0xa1b2c3d4e5f60718, {sample(1001), sample(1000)}, {frame(21), frame(20)}};
}

/// Only the head is sent; the rest stays where sample(0) has it.
inline SampleForm headOnly() {
  SampleForm form{(1U << 6) - 1, false, sample(0).units};
  return form;
}
inline SampleForm codes() {
  return {kAllDofs, true, {}};
}

/// The packet as a session of that form has it.
inline MotionPacket motion(const SampleForm& form) {
  MotionPacket packet = motion();
  const auto formed = [&](MotionSample& s) {
    if (form.compact) s = compacted(s);
    s.valid &= form.dofs;
    for (std::size_t i = 0; i < kDofCount; ++i)
      if ((form.dofs & mask(dofAt(i))) == 0) s.units[i] = form.still[i];
  };
  formed(packet.sample);
  for (MotionSample& previous : packet.previous) formed(previous);
  for (FrameState& f : packet.frames) formed(f.sample);
  return packet;
}

inline ClockProbe probe() {
  return {123'456'789'012, 3, MotionWay::Multicast};
}
inline ClockReply reply() {
  return {123'456'789'012, 5'000'000'000, 5'000'012'345};
}

}  // namespace coherency::golden
