#pragma once

#include <string>
#include <vector>

#include "common/wire/ControlCodec.h"
#include "common/wire/Discovery.h"
#include "common/wire/SealedDatagram.h"
#include "tests/wire/Generators.h"
#include "tests/wire/SealSupport.h"

/// Arbitrary valid values of everything that is said beside motion.
namespace coherency::arbitrary {

inline std::string text(std::size_t longest = kMaxText) {
  std::string any = *rc::gen::container<std::string>(rc::gen::inRange<char>(0x20, 0x7f));
  any.resize(std::min(any.size(), longest));
  return any;
}
inline std::string sceneName() {
  return *rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::elementOf(std::string("abzAZ09_-.:"))));
}

inline Hello hello() {
  return {kWireMajor, *rc::gen::arbitrary<std::uint32_t>(), sealing::arbitraryKey(),
          *rc::gen::arbitrary<bool>()};
}
inline Join join() {
  return {*rc::gen::element<std::string>("left", "right", "both", "mono"), text()};
}

inline SceneDescription scene() {
  SceneDescription s;
  s.name = sceneName();
  s.operator_shown = *rc::gen::arbitrary<bool>();
  s.driving = *rc::gen::arbitrary<bool>();
  s.start = random::base();
  s.workplace = random::base();
  if (*rc::gen::arbitrary<bool>()) s.robot = {random::base(), random::base()};
  const int objects = *rc::gen::inRange(0, 6);
  for (int i = 0; i < objects; ++i)
    s.objects.push_back(
        {text(kMaxKind), text(), random::base(), text(7), *rc::gen::inRange(0, kMaxSceneParts / 6 + 1)});
  return s;
}

inline MulticastGroup multicast() {
  const auto byte = [](int from) { return std::to_string(*rc::gen::inRange(from, from == 0 ? 256 : 240)); };
  return {byte(224) + "." + byte(0) + "." + byte(0) + "." + byte(0), *rc::gen::nonZero<std::uint16_t>()};
}

inline SessionConfig session() {
  SessionConfig s;
  s.session_id = id();
  s.client_id = *rc::gen::nonZero<std::uint32_t>();
  s.motion_key = sealing::arbitraryKey();
  s.scene = scene();
  s.rig.name = text();
  for (const RigField& field : rigFields())
    s.rig.*(field.value) = field.min + *rc::gen::inRange(0, 1001) * 1e-3 * (field.max - field.min);
  s.period_ns = *rc::gen::inRange<std::int64_t>(kMinPeriodNs, kMaxPeriodNs + 1);
  s.frame_ns = *rc::gen::inRange<std::int64_t>(kMinFrameNs, kMaxPeriodNs + 1);
  s.udp_port = *rc::gen::nonZero<std::uint16_t>();
  s.form = form();
  if (*rc::gen::arbitrary<bool>()) s.multicast = multicast();
  return s;
}

inline ClientReport report() {
  ClientReport r;
  const int frames = *rc::gen::inRange(0, 40);
  for (int i = 0; i < frames; ++i)
    r.frames.push_back({id(),
                        *rc::gen::element(Fate::Drawn, Fate::InputLate, Fate::DrawingLate, Fate::Mismatch),
                        *rc::gen::arbitrary<std::uint64_t>(), *rc::gen::arbitrary<std::uint64_t>(), timeNs(),
                        timeNs(), timeNs()});
  r.packets_received = *rc::gen::arbitrary<std::uint64_t>();
  r.packets_lost = *rc::gen::arbitrary<std::uint64_t>();
  return r;
}

inline Goodbye goodbye() {
  return {text(), *rc::gen::element(GoodbyeCause::Leaving, GoodbyeCause::Version, GoodbyeCause::Full,
                                    GoodbyeCause::Protocol, GoodbyeCause::Key)};
}
inline ModeRequest modeRequest() {
  return {*rc::gen::element(Mode::Operator, Mode::Robot)};
}
inline Tunnelled tunnelled() {
  Tunnelled t{sealing::arbitraryBytes(kMaxDatagramBody)};
  if (t.body.empty()) t.body.resize(1);
  return t;
}

inline std::vector<ControlMessage> oneOfEach() {
  return {hello(),  join(),        session(),   keyframe(), KeyframeRequest{},
          report(), modeRequest(), tunnelled(), goodbye()};
}

inline Announcement announcement() {
  return {*rc::gen::arbitrary<std::uint32_t>(),
          *rc::gen::arbitrary<std::uint32_t>(),
          text(),
          sceneName(),
          *rc::gen::nonZero<std::uint16_t>(),
          *rc::gen::arbitrary<bool>(),
          *rc::gen::arbitrary<std::uint32_t>()};
}

inline bool same(const SessionConfig& a, const SessionConfig& b) {
  return a.session_id == b.session_id && a.client_id == b.client_id && a.motion_key == b.motion_key &&
         a.scene == b.scene && a.rig == b.rig && a.period_ns == b.period_ns && a.udp_port == b.udp_port &&
         a.form == b.form && a.frame_ns == b.frame_ns && a.multicast == b.multicast;
}
inline bool same(const ControlMessage& a, const ControlMessage& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&](const auto& one) {
        const auto& other = std::get<std::decay_t<decltype(one)>>(b);
        if constexpr (std::is_same_v<std::decay_t<decltype(one)>, SessionConfig>) {
          return same(one, other);
        } else {
          return one == other;
        }
      },
      a);
}

}  // namespace coherency::arbitrary
