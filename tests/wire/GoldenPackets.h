#pragma once

#include "common/wire/Packets.h"

/// One of each kind, chosen so that every field shows. Their bytes are frozen: see GoldenBytesTest.cpp.
namespace coherency::golden {

inline MotionSample sample(std::uint64_t sequence) {
  MotionSample s;
  s.sequence = sequence;
  s.server_time_ns = 1'000'000'000'000 + static_cast<std::int64_t>(sequence) * 1'000'000;
  s.device_time_us = static_cast<std::int64_t>(sequence) * 1000 - 7;
  s.valid = kAllDofs & ~mask(Dof::Grip);
  for (std::size_t i = 0; i < kDofCount; ++i) {
    s.units[i] = static_cast<std::int32_t>(i) * 10'007 + static_cast<std::int32_t>(sequence);
  }
  // The head is on the body: its height must be one that can be.
  s.units[index(Dof::HeadY)] = 1'180'000;
  return s;
}

inline MotionPacket motion() {
  MotionPacket p;
  p.session_id = 0x1122334455667788;
  p.sample = sample(1002);
  p.world = {1002,
             Mode::Robot,
             {{1'234'567'890'123, 0, -987'654'321, -1'000'000}, 250'000, -800'000, 65'536},
             {{-5'000'000, 7, 9, 1 << 30}, 1, -2, 3},
             2,
             {},
             {},
             {17, 0, 1, false}};
  p.world.movables.push_back({Holder::RobotHand,
                              1'000'000,
                              -2'000'000,
                              3'000'000,
                              {1 << 29, 1 << 29, 1 << 29, 1 << 29},
                              0,
                              false,
                              5});
  p.world.movables.push_back(
      {Holder::Nobody, 123'456'789, 747'500'000, -987'654'321, {0, 0, 0, 1 << 30}, 9807, true, 0});
  p.world.doors = {0, kDoorOpen / 2};
  p.hash = 0xa1b2c3d4e5f60718;
  p.previous = {sample(1001), sample(1000)};
  return p;
}

inline ClockProbe probe() {
  return {0x1122334455667788, 7, 0x99aabbccddeeff00, 123'456'789'012};
}
inline ClockReply reply() {
  return {0x1122334455667788, 123'456'789'012, 5'000'000'000, 5'000'012'345};
}
inline Hello hello() {
  return {2, 0, "left", "coherency render_client"};
}

inline SessionConfig session() {
  SessionConfig s;
  s.session_id = 0x1122334455667788;
  s.client_id = 7;
  s.client_token = 0x99aabbccddeeff00;
  s.scene.name = "laboratory";
  s.scene.start = {0, 0, 1'250'000'000, 0};
  s.scene.workplace = {0, 0, -440'000'000, 0};
  s.scene.robot = {{-2'000'000'000, 0, -1'980'000'000, -(1 << 30)}, {0, 0, -1'980'000'000, INT32_MIN}};
  s.scene.objects = {{"table", "table", {0, 0, -1'200'000'000, 0}, "", 0},
                     {"block", "red block", {-20'000'000, 747'500'000, -990'000'000, 1 << 27}, "#c8433a", 0},
                     {"grid", "grid", {}, "", 1000}};
  // Every measure by its value: the default operator may grow, the golden one must not.
  s.rig = {.name = "default",
           .eye_distance = 0.064,
           .eye_forward = 0.085,
           .eye_up = 0.03,
           .neck_length = 0.14,
           .neck_back = 0.03,
           .trunk_length = 0.52,
           .shoulder_half_width = 0.19,
           .shoulder_drop = 0.05,
           .shoulder_tilt_up = 0.4363323129985824,
           .shoulder_tilt_back = 0.5235987755982988,
           .upper_arm = 0.29,
           .forearm = 0.26,
           .hand = 0.09,
           .seat_height = 0.50,
           .hip_half_width = 0.09,
           .thigh = 0.43,
           .shin = 0.42,
           .foot = 0.25,
           .robot_scale = 1.0};
  s.period_ns = 1'000'000;
  s.udp_port = 7430;
  return s;
}

inline ClientReport report() {
  return {{{1000, 0x0102030405060708, 5'000'000'000}, {1016, 0x1112131415161718, 5'016'666'667}}, 1016, 3};
}
inline Goodbye goodbye() {
  return {"the server ends", GoodbyeCause::Leaving};
}
inline ModeRequest modeRequest() {
  return {Mode::Robot};
}
inline Goodbye refusal() {
  return {"another version", GoodbyeCause::Version};
}

}  // namespace coherency::golden
