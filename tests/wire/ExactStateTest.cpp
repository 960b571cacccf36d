#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/DatagramCodec.h"
#include "common/wire/Validity.h"
#include "tests/wire/Generators.h"

// What the whole wire is built for: a keyframe and any one later packet are the exact state, whatever was
// lost, and in whatever order things came.

namespace coherency {
namespace {

struct Sent {
  MotionPacket packet;
  std::vector<std::byte> body;
};

/// A session's states one after another, and what was sent of them.
class Walk {
 public:
  explicit Walk(const SampleForm& form) : form_(form), codec_(form) {
    keyframes.push_back({*rc::gen::inRange<std::uint32_t>(1, 1000), random::state()});
    state_ = keyframes.back().world;
  }

  void step(std::uint64_t sequence) {
    state_ = arbitrary::changed(state_);
    if (*rc::gen::inRange(0, 5) == 0) keyframes.push_back({keyframes.back().number + 1, state_});
    MotionPacket packet = arbitrary::motion({keyframes.back().number, state_}, form_);
    packet.world = state_;
    packet.sample.sequence = sequence;
    packet.previous.clear();
    packet.hash = stateHash(packet.world, packet.sample);
    for (FrameState& frame : packet.frames) frame.hash = stateHash(frame.world, frame.sample);
    std::vector<std::byte> body;
    codec_.encode(packet, keyframes.back().world, body);
    sent.push_back({packet, body});
  }

  std::vector<Keyframe> keyframes;
  std::vector<Sent> sent;

 private:
  SampleForm form_;
  DatagramCodec codec_;
  WorldState state_;
};

/// Some of them, in any order.
template <class T>
std::vector<T> arrivals(const std::vector<T>& all) {
  std::vector<T> some;
  for (const std::size_t i : *rc::gen::container<std::vector<std::size_t>>(
           2 * all.size(), rc::gen::inRange<std::size_t>(0, all.size())))
    some.push_back(all[i]);
  return some;
}

void expectExact(const DecodedDatagram& decoded, const MotionPacket& sent) {
  const auto& packet = std::get<MotionPacket>(decoded);
  RC_ASSERT(packet.world == sent.world);
  RC_ASSERT(hashHolds(packet));
  for (std::size_t i = 0; i < packet.frames.size(); ++i) {
    RC_ASSERT(packet.frames[i] == sent.frames[i]);
    RC_ASSERT(hashHolds(packet.frames[i]));
  }
}

RC_GTEST_PROP(ExactState, IsAKeyframeAndAnyOnePacket, ()) {
  const SampleForm form = arbitrary::form();
  Walk walk(form);
  for (std::uint64_t i = 1; i <= 12; ++i) walk.step(i);
  KeyframeStore store;
  for (const Keyframe& keyframe : arrivals(walk.keyframes)) RC_ASSERT(!store.add(keyframe));
  DatagramCodec receiver(form);
  for (const Sent& sent : arrivals(walk.sent)) {
    const DecodedDatagram decoded = receiver.decode(sent.body, store);
    if (store.find(sent.packet.keyframe) == nullptr) {
      RC_ASSERT(std::get<Reject>(decoded) == Reject::NoKeyframe);
    } else {
      expectExact(decoded, sent.packet);
    }
  }
}

RC_GTEST_PROP(ExactState, FromAnotherKeyframeShowsInTheHash, ()) {
  const SampleForm form = arbitrary::form();
  Walk walk(form);
  walk.step(1);
  Keyframe wrong = walk.keyframes.back();
  ++wrong.world.tick;
  KeyframeStore store;
  store.add(wrong);
  const auto decoded = DatagramCodec(form).decode(walk.sent[0].body, store);
  RC_ASSERT(!hashHolds(std::get<MotionPacket>(decoded)));
}

}  // namespace
}  // namespace coherency
