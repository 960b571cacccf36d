#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/DatagramCodec.h"
#include "common/wire/SealedDatagram.h"
#include "common/wire/Validity.h"
#include "tests/wire/Generators.h"
#include "tests/wire/GoldenPackets.h"
#include "tests/wire/Protobuf.h"

namespace coherency {
namespace {

using Bytes = std::vector<std::byte>;

template <class T>
Bytes encoded(const T& value) {
  Bytes bytes;
  DatagramCodec().encode(value, bytes);
  return bytes;
}
Bytes encoded(const MotionPacket& packet, const WorldState& keyframe, const SampleForm& form = {}) {
  Bytes bytes;
  DatagramCodec(form).encode(packet, keyframe, bytes);
  return bytes;
}

KeyframeStore storeOf(const Keyframe& keyframe) {
  KeyframeStore store;
  store.add(keyframe);
  return store;
}

bool isRejected(const DecodedDatagram& decoded) {
  return std::holds_alternative<Reject>(decoded);
}
/// What a decoder may say to bytes that were tampered with: no, or something that can be true.
bool isRejectedOrValid(const DecodedDatagram& decoded) {
  return std::visit(
      [](const auto& value) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Reject>) {
          return true;
        } else {
          return isValid(value);
        }
      },
      decoded);
}

RC_GTEST_PROP(DatagramCodec, MotionComesBackAsItWas, ()) {
  const Keyframe keyframe = arbitrary::keyframe();
  const SampleForm form = arbitrary::form();
  const MotionPacket packet = arbitrary::motion(keyframe, form);
  RC_ASSERT(isValid(packet));
  const Bytes bytes = encoded(packet, keyframe.world, form);
  RC_ASSERT(bytes.size() <= kMaxDatagramBody);
  const auto decoded = std::get<MotionPacket>(DatagramCodec(form).decode(bytes, storeOf(keyframe)));
  RC_ASSERT(arbitrary::same(decoded, packet));
}

RC_GTEST_PROP(DatagramCodec, WhatDoesNotTravelStandsStill, ()) {
  const Keyframe keyframe = arbitrary::keyframe();
  SampleForm form = arbitrary::form();
  const MotionPacket packet = arbitrary::motion(keyframe, form);
  const Bytes bytes = encoded(packet, keyframe.world, form);
  for (std::size_t i = 0; i < kDofCount; ++i) form.still[i] = arbitrary::units(dofAt(i));
  const auto decoded = std::get<MotionPacket>(DatagramCodec(form).decode(bytes, storeOf(keyframe)));
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const bool travels = (form.dofs & mask(dofAt(i))) != 0;
    RC_ASSERT(decoded.sample.units[i] == (travels ? packet.sample.units[i] : form.still[i]));
  }
}

RC_GTEST_PROP(DatagramCodec, ASampleOfAnotherFormIsRefused, ()) {
  const Keyframe keyframe = arbitrary::keyframe();
  const SampleForm form = arbitrary::form();
  const Bytes bytes = encoded(arbitrary::motion(keyframe, form), keyframe.world, form);
  SampleForm other = form;
  other.dofs ^= mask(dofAt(*rc::gen::inRange<std::size_t>(0, kDofCount)));
  RC_ASSERT(std::get<Reject>(DatagramCodec(other).decode(bytes, storeOf(keyframe))) == Reject::Malformed);
  if (form.dofs == 0) return;  // without any DOFs both encodings are the same
  other = form;
  other.compact = !form.compact;
  RC_ASSERT(std::get<Reject>(DatagramCodec(other).decode(bytes, storeOf(keyframe))) == Reject::Malformed);
}

TEST(DatagramCodec, ADofThatDoesNotTravelIsNeverMeasured) {
  const SampleForm form = golden::headOnly();
  MotionPacket packet = golden::motion(form);
  packet.sample.valid |= mask(Dof::StickX);
  const Bytes bytes = encoded(packet, golden::keyframe().world, form);
  EXPECT_EQ(std::get<Reject>(DatagramCodec(form).decode(bytes, storeOf(golden::keyframe()))),
            Reject::Malformed);
}

RC_GTEST_PROP(DatagramCodec, ProbeAndReplyComeBackAsTheyWere, ()) {
  const ClockProbe probe = arbitrary::probe();
  const ClockReply reply = arbitrary::reply();
  RC_ASSERT(std::get<ClockProbe>(DatagramCodec().decode(encoded(probe), {})) == probe);
  RC_ASSERT(std::get<ClockReply>(DatagramCodec().decode(encoded(reply), {})) == reply);
}

RC_GTEST_PROP(DatagramCodec, ACodecForgetsWhatItDidBefore, ()) {
  const SampleForm form = arbitrary::form();
  DatagramCodec codec(form);
  for (int i = 0; i < 4; ++i) {
    const Keyframe keyframe = arbitrary::keyframe();
    const MotionPacket packet = arbitrary::motion(keyframe, form);
    const ClockProbe probe = arbitrary::probe();
    Bytes bytes;
    codec.encode(packet, keyframe.world, bytes);
    RC_ASSERT(bytes == encoded(packet, keyframe.world, form));
    RC_ASSERT(arbitrary::same(std::get<MotionPacket>(codec.decode(bytes, storeOf(keyframe))), packet));
    bytes.clear();
    codec.encode(probe, bytes);
    RC_ASSERT(bytes == encoded(probe));
    RC_ASSERT(std::get<ClockProbe>(codec.decode(bytes, {})) == probe);
  }
}

TEST(DatagramCodec, ABodyIsAppended) {
  Bytes bytes(5, std::byte{7});
  DatagramCodec().encode(golden::motion(), golden::keyframe().world, bytes);
  const Bytes body = encoded(golden::motion(), golden::keyframe().world);
  ASSERT_EQ(bytes.size(), 5 + body.size());
  EXPECT_TRUE(std::equal(body.begin(), body.end(), bytes.begin() + 5));
}

TEST(DatagramCodec, MotionWaitsForItsKeyframe) {
  const Bytes bytes = encoded(golden::motion(), golden::keyframe().world);
  DatagramCodec codec;
  Keyframe other = golden::keyframe();
  ++other.number;
  EXPECT_EQ(std::get<Reject>(codec.decode(bytes, {})), Reject::NoKeyframe);
  EXPECT_EQ(std::get<Reject>(codec.decode(bytes, storeOf(other))), Reject::NoKeyframe);
  EXPECT_FALSE(isRejected(codec.decode(bytes, storeOf(golden::keyframe()))));
}

RC_GTEST_PROP(DatagramCodec, OneWrongByteNeverYieldsWhatCannotBe, ()) {
  const Keyframe keyframe = arbitrary::keyframe();
  const KeyframeStore store = storeOf(keyframe);
  const SampleForm form = arbitrary::form();
  const std::array<Bytes, 3> bodies{encoded(arbitrary::motion(keyframe, form), keyframe.world, form),
                                    encoded(arbitrary::probe()), encoded(arbitrary::reply())};
  DatagramCodec codec(form);
  for (const Bytes& good : bodies) {
    for (std::size_t i = 0; i < good.size(); ++i) {
      Bytes bad = good;
      bad[i] ^= static_cast<std::byte>(*rc::gen::inRange(1, 256));
      RC_ASSERT(isRejectedOrValid(codec.decode(bad, store)));
    }
  }
}

TEST(DatagramCodec, MotionCutAnywhereIsRefused) {
  const KeyframeStore store = storeOf(golden::keyframe());
  for (const SampleForm& form : {SampleForm{}, golden::codes(), golden::headOnly()}) {
    const Bytes good = encoded(golden::motion(form), golden::keyframe().world, form);
    DatagramCodec codec(form);
    for (std::size_t size = 0; size < good.size(); ++size)
      EXPECT_TRUE(isRejected(codec.decode(std::span(good).first(size), store))) << size;
    EXPECT_FALSE(isRejected(codec.decode(good, store)));
  }
}

TEST(DatagramCodec, OtherBodiesCutAnywhereAreRefused) {
  for (const Bytes& good : {encoded(golden::probe()), encoded(golden::reply())}) {
    for (std::size_t size = 0; size < good.size(); ++size)
      EXPECT_TRUE(isRejected(DatagramCodec().decode(std::span(good).first(size), {}))) << size;
    EXPECT_FALSE(isRejected(DatagramCodec().decode(good, {})));
  }
}

RC_GTEST_PROP(DatagramCodec, RandomBytesNeverYieldWhatCannotBe, (const std::vector<std::uint8_t>& noise)) {
  RC_ASSERT(isRejectedOrValid(
      DatagramCodec().decode(std::as_bytes(std::span(noise)), storeOf(golden::keyframe()))));
}

TEST(DatagramCodec, RefusalsTellTheirCause) {
  DatagramCodec codec;
  EXPECT_EQ(std::get<Reject>(codec.decode(Bytes(kMaxDatagramBody + 1), {})), Reject::Oversized);
  EXPECT_EQ(std::get<Reject>(codec.decode({}, {})), Reject::Malformed);
}

TEST(DatagramCodec, UnknownFieldsOfANewerMinorAreIgnored) {
  const Bytes motion = encoded(golden::motion(), golden::keyframe().world);
  DatagramCodec codec;
  const auto decoded = codec.decode(protobuf::withUnknownFields(motion), storeOf(golden::keyframe()));
  EXPECT_EQ(std::get<MotionPacket>(decoded), golden::motion());
  EXPECT_EQ(std::get<ClockProbe>(codec.decode(protobuf::withUnknownFields(encoded(golden::probe())), {})),
            golden::probe());
  EXPECT_EQ(std::get<ClockReply>(codec.decode(protobuf::withUnknownFields(encoded(golden::reply())), {})),
            golden::reply());
}

// What no encoder of ours makes, by hand, in a session of which no DOF travels.

/// Motion whose World has these fields, or that lacks what `parts` leaves out.
struct MadeMotion {
  std::uint64_t keyframe = 3;
  std::string sample = protobuf::field(2, protobuf::field(1, std::uint64_t{9}));
  std::string world = protobuf::field(3, std::string());
  std::string rest = {};

  DecodedDatagram decoded() const {
    const std::string motion = protobuf::field(1, keyframe) + sample + world + rest;
    return DatagramCodec({0, false, {}})
        .decode(protobuf::bytes(protobuf::field(1, motion)), storeOf(golden::keyframe()));
  }
};

/// Lists of movables (field 7 of World) or doors (8) with these places.
std::string places(std::uint32_t list, std::initializer_list<std::uint64_t> indices) {
  std::string world;
  for (const std::uint64_t i : indices) world += protobuf::field(list, protobuf::field(1, i));
  return protobuf::field(3, world);
}

TEST(DatagramCodec, MotionByHandIsUnderstood) {
  EXPECT_EQ(std::get<MotionPacket>(MadeMotion{}.decoded()).world, [] {
    WorldState world = golden::keyframe().world;
    world.mode = Mode::Operator;
    world.closed_hands = 0;
    return world;
  }());
}

TEST(DatagramCodec, MotionLacksNothing) {
  EXPECT_TRUE(isRejected(MadeMotion{.sample = ""}.decoded()));
  EXPECT_TRUE(isRejected(MadeMotion{.world = ""}.decoded()));
  MadeMotion unnumbered;
  unnumbered.keyframe = 0;
  EXPECT_EQ(std::get<Reject>(unnumbered.decoded()), Reject::Malformed)
      << "0 is no keyframe one could wait for";
}

TEST(DatagramCodec, AFrameLacksNothing) {
  const std::string sample = protobuf::field(2, protobuf::field(1, std::uint64_t{9}));
  const std::string world = protobuf::field(3, std::string());
  const auto decoded = [](const std::string& frame) {
    return MadeMotion{.rest = protobuf::field(6, frame)}.decoded();
  };
  EXPECT_FALSE(isRejected(decoded(sample + world)));
  EXPECT_TRUE(isRejected(decoded(sample)));
  EXPECT_TRUE(isRejected(decoded(world)));
}

TEST(DatagramCodec, ListsNamePlacesThereAreOnceAndRising) {
  for (const std::uint32_t list : {7U, 8U}) {  // the keyframe has three of each
    const auto rejected = [&](std::initializer_list<std::uint64_t> indices) {
      return isRejected(MadeMotion{.world = places(list, indices)}.decoded());
    };
    EXPECT_FALSE(rejected({0, 1, 2})) << list;
    EXPECT_FALSE(rejected({1})) << list;
    EXPECT_TRUE(rejected({3})) << list;
    EXPECT_TRUE(rejected({0, 0xffffffff})) << list;
    EXPECT_TRUE(rejected({1, 1})) << list;
    EXPECT_TRUE(rejected({2, 0})) << list;
    EXPECT_TRUE(rejected({0, 1, 2, 3})) << list;
  }
}

TEST(DatagramCodec, WhatNoStateHasIsRefused) {
  const auto rejected = [](const std::string& world) {
    return isRejected(MadeMotion{.world = protobuf::field(3, world)}.decoded());
  };
  const auto movable = [](const std::string& fields) { return protobuf::field(7, fields); };
  EXPECT_FALSE(rejected(protobuf::field(2, std::uint64_t{1}))) << "robot";
  EXPECT_TRUE(rejected(protobuf::field(2, std::uint64_t{2}))) << "no such mode";
  EXPECT_TRUE(rejected(protobuf::field(3, std::uint64_t{4}))) << "there are two hands";
  EXPECT_FALSE(rejected(movable(protobuf::field(2, std::uint64_t{2})))) << "in the robot's hand";
  EXPECT_TRUE(rejected(movable(protobuf::field(2, std::uint64_t{3})))) << "no such hand";
  EXPECT_TRUE(rejected(movable(protobuf::field(3, ~std::uint64_t{0})))) << "out of the world";
  EXPECT_TRUE(rejected(movable(protobuf::field(6, std::string(12, '\0'))))) << "three of four components";
  EXPECT_TRUE(rejected(movable(protobuf::field(6, std::string(16, '\0'))))) << "no rotation";
  EXPECT_TRUE(rejected(movable(protobuf::field(9, std::uint64_t{kPatienceUs} + 1)))) << "too patient";
  const auto door = [](std::uint64_t open) { return protobuf::field(8, protobuf::field(2, open)); };
  EXPECT_FALSE(rejected(door(std::uint64_t{kDoorOpen} << 1))) << "zigzag: open";
  EXPECT_TRUE(rejected(door(1))) << "zigzag: -1";
  EXPECT_TRUE(rejected(door((std::uint64_t{kDoorOpen} << 1) + 2))) << "wider than open";
}

TEST(DatagramCodec, MorePreviousSamplesOrFramesThanThereMayBeAreRefused) {
  const auto sample = [](std::uint64_t sequence) { return protobuf::field(1, sequence); };
  std::string previous;
  for (std::uint64_t i = 0; i < kMaxPrevious; ++i) previous += protobuf::field(5, sample(8 - i));
  EXPECT_FALSE(isRejected(MadeMotion{.rest = previous}.decoded()));
  EXPECT_TRUE(isRejected(MadeMotion{.rest = previous + protobuf::field(5, sample(1))}.decoded()));
  std::string frames;
  const auto frame = [&](std::uint64_t number) {
    return protobuf::field(
        6, protobuf::field(1, number) + protobuf::field(2, sample(9)) + protobuf::field(3, std::string()));
  };
  for (std::uint64_t i = 0; i < kMaxFrames; ++i) frames += frame(8 - i);
  EXPECT_FALSE(isRejected(MadeMotion{.rest = frames}.decoded()));
  EXPECT_TRUE(isRejected(MadeMotion{.rest = frames + frame(1)}.decoded()));
}

}  // namespace
}  // namespace coherency
