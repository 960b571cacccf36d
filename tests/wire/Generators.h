#pragma once

#include <string>

#include <rapidcheck.h>

#include "common/math/FixedPoint.h"
#include "common/wire/Packets.h"
#include "common/wire/Validity.h"
#include "tests/world/Generators.h"

/// Arbitrary valid values of everything that travels.
namespace coherency::arbitrary {

inline std::uint64_t id() {
  return *rc::gen::nonZero<std::uint64_t>();
}
inline std::int64_t timeNs() {
  return *rc::gen::inRange<std::int64_t>(0, kMaxTimeNs);
}

inline std::string text() {
  return *rc::gen::container<std::string>(rc::gen::inRange<char>(0x20, 0x7f));
}

/// Every integer unit from one end of the DOF's range to the other.
inline std::int32_t units(Dof dof) {
  const DofInfo& d = info(dof);
  const double fraction = *rc::gen::inRange(0, 1'000'001) * 1e-6;
  return unitsFromSi(d.kind, d.min + fraction * (d.max - d.min));
}

inline MotionSample sample(std::uint64_t sequence) {
  MotionSample s;
  s.sequence = sequence;
  s.server_time_ns = timeNs();
  s.device_time_us = *rc::gen::arbitrary<std::int64_t>();
  s.valid = *rc::gen::inRange<DofMask>(0, kAllDofs + 1);
  for (std::size_t i = 0; i < kDofCount; ++i) {
    s.units[i] = s.isValid(dofAt(i)) ? units(dofAt(i)) : *rc::gen::arbitrary<std::int32_t>();
  }
  return s;
}

inline MotionPacket motion() {
  MotionPacket p;
  p.session_id = id();
  p.hash = *rc::gen::arbitrary<std::uint64_t>();
  p.world = random::state();
  const auto previous = *rc::gen::inRange<std::uint64_t>(0, kMaxPrevious + 1);
  const auto sequence = *rc::gen::inRange<std::uint64_t>(kMaxPrevious + 1, std::uint64_t{1} << 62);
  p.sample = sample(sequence);
  for (std::uint64_t i = 1; i <= previous; ++i) p.previous.push_back(sample(sequence - i));
  return p;
}

inline ClockProbe probe() {
  return {id(), *rc::gen::nonZero<std::uint32_t>(), *rc::gen::arbitrary<std::uint64_t>(), timeNs()};
}

inline ClockReply reply() {
  const std::int64_t received = timeNs();
  return {id(), timeNs(), received, *rc::gen::inRange<std::int64_t>(received, kMaxTimeNs + 1)};
}

inline Hello hello() {
  const auto eye = rc::gen::element<std::string>("left", "right", "both", "mono");
  return {kWireMajor, *rc::gen::arbitrary<std::uint32_t>(), *eye, text()};
}

inline SceneDescription scene() {
  SceneDescription s;
  s.name =
      *rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::elementOf(std::string("abzAZ09_-.:"))));
  s.operator_shown = *rc::gen::arbitrary<bool>();
  s.driving = *rc::gen::arbitrary<bool>();
  s.start = random::base();
  s.workplace = random::base();
  if (*rc::gen::arbitrary<bool>()) s.robot = {random::base(), random::base()};
  const int objects = *rc::gen::inRange(0, 6);
  for (int i = 0; i < objects; ++i)
    s.objects.push_back(
        {text(), text(), random::base(), text(), *rc::gen::inRange(0, kMaxSceneParts / 6 + 1)});
  return s;
}

inline SessionConfig session() {
  SessionConfig s;
  s.session_id = id();
  s.client_id = *rc::gen::nonZero<std::uint32_t>();
  s.client_token = *rc::gen::arbitrary<std::uint64_t>();
  s.scene = scene();
  s.rig.name = text();
  for (const RigField& field : rigFields()) {
    s.rig.*(field.value) = field.min + *rc::gen::inRange(0, 1001) * 1e-3 * (field.max - field.min);
  }
  s.period_ns = *rc::gen::inRange<std::int64_t>(kMinPeriodNs, kMaxPeriodNs + 1);
  s.udp_port = *rc::gen::nonZero<std::uint16_t>();
  return s;
}

inline ClientReport report() {
  ClientReport r;
  const int frames = *rc::gen::inRange(0, 40);
  for (int i = 0; i < frames; ++i) r.frames.push_back({id(), *rc::gen::arbitrary<std::uint64_t>(), timeNs()});
  r.packets_received = *rc::gen::arbitrary<std::uint64_t>();
  r.packets_lost = *rc::gen::arbitrary<std::uint64_t>();
  return r;
}

inline Goodbye goodbye() {
  return {text(), static_cast<GoodbyeCause>(*rc::gen::inRange(0, 4))};
}

inline ModeRequest modeRequest() {
  return {*rc::gen::element(Mode::Operator, Mode::Robot)};
}

/// Equal but for the oldest previous samples, which may have had no room.
inline bool same(const MotionPacket& decoded, MotionPacket sent) {
  if (decoded.previous.size() > sent.previous.size()) return false;
  sent.previous.resize(decoded.previous.size());
  return decoded == sent;
}

inline bool same(const SessionConfig& a, const SessionConfig& b) {
  for (const RigField& field : rigFields()) {
    if (a.rig.*(field.value) != b.rig.*(field.value)) return false;
  }
  return a.session_id == b.session_id && a.client_id == b.client_id && a.client_token == b.client_token &&
         a.scene == b.scene && a.rig.name == b.rig.name && a.period_ns == b.period_ns &&
         a.udp_port == b.udp_port;
}

}  // namespace coherency::arbitrary
