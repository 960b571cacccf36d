#pragma once

#include "common/wire/Discovery.h"
#include "common/wire/Messages.h"
#include "tests/wire/SealSupport.h"

/// What is said beside motion, one of each kind, chosen so that every field shows. The bytes are frozen: see
/// GoldenBytesTest.cpp.
namespace coherency::golden {

inline Hello hello() {
  return {3, 0, sealing::countingKey(1), true};
}
inline Join join() {
  return {"left", "coherency render_client"};
}

inline SceneDescription scene() {
  SceneDescription s;
  s.name = "laboratory";
  s.start = {0, 0, 1'250'000'000, 0};
  s.workplace = {0, 0, -440'000'000, 0};
  s.robot = {{-2'000'000'000, 0, -1'980'000'000, -(1 << 30)}, {0, 0, -1'980'000'000, INT32_MIN}};
  s.objects = {{"table", "table", {0, 0, -1'200'000'000, 0}, "", 0},
               {"block", "red block", {-20'000'000, 747'500'000, -990'000'000, 1 << 27}, "#c8433a", 0},
               {"grid", "grid", {}, "", 1000}};
  return s;
}

/// Every measure by its value: the default operator may grow, the golden one must not.
inline Rig rig() {
  return {.name = "default",
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
}

inline SessionConfig session() {
  SessionConfig s;
  s.session_id = 0x1122334455667788;
  s.client_id = 7;
  s.motion_key = sealing::countingKey(33);
  s.scene = scene();
  s.rig = rig();
  s.period_ns = 1'000'000;
  s.udp_port = 7430;
  s.form = {kAllDofs & ~mask(Dof::PedalLeft), true, {}};
  for (std::size_t i = 0; i < kDofCount; ++i) s.form.still[i] = static_cast<std::int32_t>(i);
  s.frame_ns = 16'666'667;
  s.multicast = {"239.7.43.0", 7432};
  return s;
}

inline ClientReport report() {
  return {{{1000, Fate::Drawn, 60'000, 0x0102030405060708, 5'000'000'000, 4'963'000'000, 9'000'000},
           {1001, Fate::Mismatch, 60'017, 0x1112131415161718, 0, 4'979'100'000, 0}},
          1016,
          3};
}
inline ModeRequest modeRequest() {
  return {Mode::Robot};
}
inline Tunnelled tunnelled() {
  return {sealing::bytesOf("the body of a datagram")};
}
inline Goodbye goodbye() {
  return {"the server ends", GoodbyeCause::Leaving};
}
inline Goodbye refusal() {
  return {"another version", GoodbyeCause::Version};
}

inline Announcement announcement() {
  return {3, 0, "motion-pc", "laboratory", 7430, true, 2};
}

}  // namespace coherency::golden
