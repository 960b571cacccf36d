#include <iostream>

#include <gtest/gtest.h>

#include "common/wire/DatagramCodec.h"
#include "common/wire/SealedDatagram.h"
#include "common/wire/Validity.h"
#include "tests/math/Random.h"

// Whether packets have room for what they should carry. A scene as the laboratory is, after a day.

namespace coherency {
namespace {

constexpr std::uint64_t kSequence = 86'400'000;
constexpr std::int64_t kNowNs = 86'400'000'000'000;
constexpr std::size_t kMovables = 3;
constexpr std::size_t kDoors = 4;

SampleForm exact() {
  return {};
}
SampleForm codes() {
  return {kAllDofs, true, {}};
}

MotionSample sample(std::uint64_t sequence, const SampleForm& form) {
  MotionSample s;
  s.sequence = sequence;
  s.server_time_ns = kNowNs;
  s.device_time_us = kNowNs / 1000;
  s.valid = kAllDofs;
  s.units.fill(300'000);
  return form.compact ? compacted(s) : s;
}

Movable lying(int i) {
  Movable m{Holder::Nobody, 123'456'789 + 60'000'000 * i, 747'500'000, -987'654'321};
  setAttitude(m, quaternion(TransformMatrix::rotationY(0.1 + i)));
  return m;
}
/// Tips over an edge, half a second into its fall.
void fall(Movable& m, std::int64_t ticks) {
  m.y_nm -= 4'905 * ticks * ticks;
  m.x_nm += 98'765 * ticks;
  m.z_nm -= 87'654 * ticks;
  m.fall_um = static_cast<std::int32_t>(9'807 * ticks);
  m.resting = false;
  m.unrest_us = static_cast<std::uint32_t>(1000 * ticks);
  setAttitude(m, quaternion(TransformMatrix::rotation(normalized(Coord3{1, 2, 3}),
                                                      0.002 * static_cast<double>(ticks))));
}
void drive(Vehicle& v, std::int64_t ticks) {
  v.base.x_nm += 567'890 * ticks;
  v.base.z_nm -= 456'789 * ticks;
  v.base.heading_units += static_cast<std::int32_t>(12'345 * ticks);
  v.velocity_right_um = 10'000;
  v.velocity_ahead_um = 720'000;
  v.turn_rate_units = 1 << 24;
}

WorldState still(std::size_t movables = kMovables) {
  WorldState w;
  w.tick = kSequence - 1000;
  w.master.base = {1'500'000'000, 0, -2'500'000'000, 1 << 28};
  w.robot.base = {-2'000'000'000, 0, -1'980'000'000, -(1 << 30)};
  for (std::size_t i = 0; i < movables; ++i) w.movables.push_back(lying(static_cast<int>(i)));
  w.doors.resize(kDoors);
  w.task = {kSequence / 2, kSequence / 4 * 3, 17, false};
  return w;
}

/// With two previous samples, and the next two frames of 16 ms, `later` telling what the world is then.
template <class Later>
MotionPacket packetOf(const WorldState& keyframe, const SampleForm& form, Later later) {
  MotionPacket p{1, sample(kSequence, form), keyframe, ~std::uint64_t{0}, {}, {}};
  later(p.world, 500);
  p.world.tick += 500;
  for (std::uint64_t i = 1; i <= 2; ++i) p.previous.push_back(sample(kSequence - i, form));
  for (std::uint64_t number : {5'400'002U, 5'400'001U}) {
    const int ticks = 16 * static_cast<int>(number - 5'400'000U);
    FrameState f{number, sample(kSequence, form), keyframe, ~std::uint64_t{0}};
    later(f.world, 500 + ticks);
    f.world.tick = p.world.tick + static_cast<std::uint64_t>(ticks);
    p.frames.push_back(f);
  }
  return p;
}

struct Fitted {
  std::size_t size;
  MotionPacket decoded;
};
Fitted fitted(const MotionPacket& packet, const WorldState& keyframe, const SampleForm& form) {
  EXPECT_TRUE(isValid(packet));
  DatagramCodec codec(form);
  std::vector<std::byte> bytes;
  codec.encode(packet, keyframe, bytes);
  KeyframeStore store;
  store.add({packet.keyframe, keyframe});
  return {bytes.size(), std::get<MotionPacket>(codec.decode(bytes, store))};
}

void print(const char* what, const SampleForm& form, const Fitted& packet) {
  std::cout << what << (form.compact ? ", compact: " : ", exact: ") << packet.size << " bytes, "
            << packet.decoded.previous.size() << " previous samples, " << packet.decoded.frames.size()
            << " frames\n";
}

TEST(PacketSize, AUsualPacketCarriesAll) {
  for (const SampleForm& form : {exact(), codes()}) {
    const WorldState keyframe = still();
    const MotionPacket packet = packetOf(keyframe, form, [](WorldState& w, int ticks) {
      drive(w.master, ticks);
      w.closed_hands = 1;
      w.movables[0] = {Holder::OperatorHand, 1'234'567, -7'654'321, 12'345'678};
    });
    const Fitted fit = fitted(packet, keyframe, form);
    print("usual packet", form, fit);
    EXPECT_LE(fit.size, kMaxDatagramBody);
    EXPECT_EQ(fit.decoded, packet);
  }
}

TEST(PacketSize, EverythingInMotionLeavesRoomForTheNewestFrame) {
  for (const SampleForm& form : {exact(), codes()}) {
    const WorldState keyframe = still(kMaxMovables);
    const MotionPacket packet = packetOf(keyframe, form, [](WorldState& w, int ticks) {
      drive(w.master, ticks);
      drive(w.robot, ticks);
      for (Movable& movable : w.movables) fall(movable, ticks);
      w.doors[0] = 1'234'567 * ticks;
      w.doors[1] = kDoorOpen - 1'234'567 * ticks;
    });
    const Fitted fit = fitted(packet, keyframe, form);
    print("everything in motion", form, fit);
    EXPECT_EQ(fit.decoded.world, packet.world);
    ASSERT_GE(fit.decoded.frames.size(), 1U);
    EXPECT_EQ(fit.decoded.frames[0], packet.frames[0]);
  }
}

/// A state each of whose numbers takes the most bytes when it differs from one with everything zero.
WorldState longest() {
  const Vehicle vehicle{
      {-kWorldLimitNm, -kWorldLimitNm, -kWorldLimitNm, -1}, -kFastestUm, -kFastestUm, -kFastestTurn};
  WorldState w{~std::uint64_t{0} / 2, Mode::Robot, vehicle, vehicle, 3, {}, {}, {}};
  w.task = {~std::uint64_t{0}, ~std::uint64_t{0}, ~0U, true};
  const Movable movable{Holder::RobotHand,  -kWorldLimitNm, -kWorldLimitNm, -kWorldLimitNm,
                        {0, 0, 0, 1 << 30}, kFastestFallUm, true,           kPatienceUs};
  w.movables.assign(kMaxMovables, movable);
  w.doors.assign(kMaxDoors, kDoorOpen);
  return w;
}
WorldState farFrom(const WorldState& longest) {
  WorldState w;
  w.movables.assign(longest.movables.size(),
                    {Holder::Nobody, kWorldLimitNm, kWorldLimitNm, kWorldLimitNm, {1 << 30, 0, 0, 0}});
  w.doors.assign(longest.doors.size(), 0);
  return w;
}

TEST(PacketSize, TheLargestPacketFitsWithoutWhatItIsNotMadeFor) {
  for (const SampleForm& form : {exact(), codes()}) {
    MotionPacket packet{~0U, sample(~std::uint64_t{0}, form), longest(), ~std::uint64_t{0}, {}, {}};
    packet.sample.device_time_us = INT64_MIN;
    packet.previous.assign(kMaxPrevious, packet.sample);
    for (std::size_t i = 0; i < kMaxPrevious; ++i) packet.previous[i].sequence -= i + 1;
    for (std::size_t i = 0; i < kMaxFrames; ++i)
      packet.frames.push_back({~std::uint64_t{0} - i, packet.sample, farFrom(packet.world), 1});
    const Fitted fit = fitted(packet, farFrom(packet.world), form);
    print("largest packet", form, fit);
    EXPECT_LE(fit.size, kMaxDatagramBody);
    EXPECT_EQ(fit.decoded.world, packet.world) << "the state is whole";
    EXPECT_EQ(fit.decoded.sample, packet.sample);
    EXPECT_TRUE(fit.decoded.previous.empty()) << "they go before a frame does";
    EXPECT_LT(fit.decoded.frames.size(), kMaxFrames);
  }
}

TEST(PacketSize, PreviousSamplesGoBeforeFramesAndTheOldestFirst) {
  const WorldState keyframe = still();
  const MotionPacket all = [&] {
    MotionPacket p = packetOf(keyframe, exact(), [](WorldState& w, int ticks) { drive(w.master, ticks); });
    for (std::uint64_t i = 3; i <= kMaxPrevious; ++i) p.previous.push_back(sample(kSequence - i, exact()));
    return p;
  }();
  const Fitted fit = fitted(all, keyframe, exact());
  print("seven previous samples", exact(), fit);
  EXPECT_EQ(fit.decoded.frames, all.frames);
  const std::size_t kept = fit.decoded.previous.size();
  ASSERT_GE(kept, 1U);
  ASSERT_LT(kept, kMaxPrevious);
  EXPECT_TRUE(std::equal(fit.decoded.previous.begin(), fit.decoded.previous.end(), all.previous.begin()));
  // No more than had to go: one more sample is as long as the difference that one makes.
  MotionPacket fewer = all;
  fewer.previous.resize(kept - 1);
  const std::size_t one = fit.size - fitted(fewer, keyframe, exact()).size;
  EXPECT_GT(fit.size + one, kMaxDatagramBody);
}

}  // namespace
}  // namespace coherency
