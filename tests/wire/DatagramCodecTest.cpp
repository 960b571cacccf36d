#include <iostream>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/wire/DatagramCodec.h"
#include "common/wire/Validity.h"
#include "tests/wire/Generators.h"

namespace coherency {
namespace {

using Bytes = std::vector<std::byte>;

template <class T>
Bytes encoded(const T& value) {
  Bytes bytes;
  DatagramCodec().encode(value, bytes);
  return bytes;
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

MotionPacket usualPacket() {
  MotionPacket packet;
  packet.session_id = 0x0123456789abcdef;
  for (std::uint64_t sequence : {100'000U, 99'999U, 99'998U}) {
    MotionSample sample;
    sample.sequence = sequence;
    sample.server_time_ns = 86'400'000'000'000;
    sample.device_time_us = 100'000'000;
    sample.valid = kAllDofs;
    sample.units.fill(300'000);
    if (sequence == 100'000U) {
      packet.sample = sample;
    } else {
      packet.previous.push_back(sample);
    }
  }
  packet.world.tick = 100'000;
  packet.world.master = {{1'500'000'000, 0, -2'500'000'000, 1 << 28}, 10'000, 600'000, -1 << 24};
  packet.world.robot = {{-2'000'000'000, 0, -1'980'000'000, -(1 << 30)}, 0, 0, 0};
  packet.world.doors = {0, 0, kDoorOpen};
  packet.world.movables.resize(3);
  for (Movable& m : packet.world.movables) m.x_nm = 123'456'789, m.y_nm = 747'500'000, m.z_nm = -987'654'321;
  packet.hash = stateHash(packet.world, packet.sample);
  return packet;
}

TEST(DatagramCodec, AUsualPacketIsSmall) {
  const std::size_t size = encoded(usualPacket()).size();
  std::cout << "motion packet with two redundant samples: " << size << " bytes\n";
  EXPECT_LE(size, 576U);
}

TEST(DatagramCodec, TheLargestPacketFitsADatagram) {
  MotionPacket packet = usualPacket();
  packet.sample.sequence = ~std::uint64_t{0};
  packet.sample.device_time_us = INT64_MIN;
  packet.previous.assign(kMaxPrevious, packet.sample);
  for (std::size_t i = 0; i < kMaxPrevious; ++i) packet.previous[i].sequence -= i + 1;
  const Vehicle longest{
      {-kWorldLimitNm, -kWorldLimitNm, -kWorldLimitNm, -1}, -kFastestUm, -kFastestUm, -kFastestTurn};
  packet.world = {~std::uint64_t{0},
                  Mode::Robot,
                  longest,
                  longest,
                  3,
                  {},
                  {},
                  {~std::uint64_t{0}, ~std::uint64_t{0}, ~0U, true}};
  packet.world.movables.assign(kMaxMovables, {Holder::RobotHand,
                                              -kWorldLimitNm,
                                              -kWorldLimitNm,
                                              -kWorldLimitNm,
                                              {0, 0, 0, 1 << 30},
                                              kFastestFallUm,
                                              true,
                                              kPatienceUs});
  packet.world.doors.assign(kMaxDoors, kDoorOpen);
  ASSERT_TRUE(isValid(packet));
  EXPECT_LE(encoded(packet).size(), kMaxDatagram);
  const auto decoded = std::get<MotionPacket>(DatagramCodec().decode(encoded(packet)));
  EXPECT_EQ(decoded.world, packet.world) << "the state is whole";
  EXPECT_EQ(decoded.sample, packet.sample);
  EXPECT_GE(decoded.previous.size(), 1U) << "and of the samples before as many come along as fit";
  EXPECT_LT(decoded.previous.size(), kMaxPrevious);
}

RC_GTEST_PROP(DatagramCodec, MotionComesBackAsItWas, ()) {
  const MotionPacket packet = arbitrary::motion();
  RC_ASSERT(isValid(packet));
  RC_ASSERT(arbitrary::same(std::get<MotionPacket>(DatagramCodec().decode(encoded(packet))), packet));
}

RC_GTEST_PROP(DatagramCodec, ProbeAndReplyComeBackAsTheyWere, ()) {
  const ClockProbe probe = arbitrary::probe();
  const ClockReply reply = arbitrary::reply();
  RC_ASSERT(std::get<ClockProbe>(DatagramCodec().decode(encoded(probe))) == probe);
  RC_ASSERT(std::get<ClockReply>(DatagramCodec().decode(encoded(reply))) == reply);
}

RC_GTEST_PROP(DatagramCodec, ACodecForgetsWhatItDidBefore, ()) {
  DatagramCodec codec;
  Bytes bytes;
  for (int i = 0; i < 5; ++i) {
    const MotionPacket packet = arbitrary::motion();
    const ClockProbe probe = arbitrary::probe();
    codec.encode(packet, bytes);
    RC_ASSERT(bytes == encoded(packet));
    RC_ASSERT(arbitrary::same(std::get<MotionPacket>(codec.decode(bytes)), packet));
    codec.encode(probe, bytes);
    RC_ASSERT(bytes == encoded(probe));
    RC_ASSERT(std::get<ClockProbe>(codec.decode(bytes)) == probe);
  }
}

RC_GTEST_PROP(DatagramCodec, OneWrongByteNeverYieldsWhatCannotBe, ()) {
  const std::array<Bytes, 3> packets{encoded(arbitrary::motion()), encoded(arbitrary::probe()),
                                     encoded(arbitrary::reply())};
  DatagramCodec codec;
  for (const Bytes& good : packets) {
    for (std::size_t i = 0; i < good.size(); ++i) {
      Bytes bad = good;
      bad[i] ^= static_cast<std::byte>(*rc::gen::inRange(1, 256));
      const DecodedDatagram decoded = codec.decode(bad);
      RC_ASSERT(isRejectedOrValid(decoded));
      if (i < kEnvelopePrefix) RC_ASSERT(isRejected(decoded));
    }
  }
}

TEST(DatagramCodec, EveryTruncationIsRefused) {
  const std::array<Bytes, 3> packets{encoded(usualPacket()), encoded(ClockProbe{1, 2, 3, 4}),
                                     encoded(ClockReply{1, 2, 3, 4})};
  DatagramCodec codec;
  for (const Bytes& good : packets) {
    for (std::size_t size = 0; size < good.size(); ++size) {
      EXPECT_TRUE(isRejectedOrValid(codec.decode(std::span(good).first(size)))) << size;
    }
    EXPECT_FALSE(isRejected(codec.decode(good)));
  }
  // Cut anywhere before its last field, a motion packet is none.
  for (std::size_t size = 0; size < packets[0].size(); ++size) {
    EXPECT_TRUE(isRejected(codec.decode(std::span(packets[0]).first(size)))) << size;
  }
}

RC_GTEST_PROP(DatagramCodec, RandomBytesAreRefused, (const std::vector<std::uint8_t>& noise)) {
  DatagramCodec codec;
  RC_ASSERT(isRejected(codec.decode(std::as_bytes(std::span(noise)))));
  Bytes behind_prefix;
  beginEnvelope(behind_prefix);
  for (const std::uint8_t b : noise) behind_prefix.push_back(std::byte{b});
  RC_ASSERT(isRejectedOrValid(codec.decode(behind_prefix)));
}

TEST(DatagramCodec, RefusalsTellTheirCause) {
  DatagramCodec codec;
  Bytes bytes = encoded(ClockProbe{1, 2, 3, 4});
  bytes[3] = std::byte{kWireMajor + 1};
  EXPECT_EQ(std::get<Reject>(codec.decode(bytes)), Reject::Version);
  bytes[0] = std::byte{'X'};
  EXPECT_EQ(std::get<Reject>(codec.decode(bytes)), Reject::Malformed);
  EXPECT_EQ(std::get<Reject>(codec.decode(Bytes(kMaxDatagram + 1))), Reject::Oversized);
  EXPECT_EQ(std::get<Reject>(codec.decode({})), Reject::Malformed);
}

}  // namespace
}  // namespace coherency
