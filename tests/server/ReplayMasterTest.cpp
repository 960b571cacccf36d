#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/FixedPoint.h"
#include "common/motion/SampleGate.h"
#include "motion_server/device/ReplayMaster.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;
const ReplayOptions kOnce{.loop = false, .head_height = HeadHeight::Recorded};

Recording twoRows() {
  Recording r;
  r.name = "two";
  r.measured = 0x1FFF;
  r.rows.resize(2);
  r.rows[0].head = {0.0, 1.6, 0.0};
  r.rows[1].time_ns = 20 * kMillisecond;
  r.rows[1].head = {0.2, 1.7, -0.1};
  r.rows[1].attitude = quaternion(rotation(YawPitchRoll{0.6, 0.0, 0.0}));
  r.rows[1].arm = {1.0, 0.5, 0.0, 2.0, 0.0, 0.0, 0.0};
  return r;
}

double at(const MasterReading& r, Dof dof) {
  return r.si[index(dof)];
}

TEST(ReplayMaster, InterpolatesLengthsAndJointsLinearlyAndAttitudeOnTheSphere) {
  ReplayMaster master(twoRows(), Rig{}, kOnce);
  const auto reading = master.read(5 * kMillisecond, {});
  ASSERT_TRUE(reading);
  EXPECT_NEAR(at(*reading, Dof::HeadX), 0.05, 1e-12);
  EXPECT_NEAR(at(*reading, Dof::HeadY), 1.625, 1e-12);
  EXPECT_NEAR(at(*reading, Dof::HeadYaw), 0.15, 1e-9);
  EXPECT_NEAR(at(*reading, Dof::HeadPitch), 0.0, 1e-9);
  EXPECT_NEAR(at(*reading, Dof::ShoulderFlexion), 0.25, 1e-12);
  EXPECT_NEAR(at(*reading, Dof::ElbowFlexion), 0.5, 1e-12);
  EXPECT_EQ(reading->device_time_us, 5000);
}

TEST(ReplayMaster, WhatWasNotMeasuredIsNotValid) {
  ReplayMaster master(twoRows(), Rig{}, kOnce);
  EXPECT_EQ(master.read(0, {})->valid, DofMask{0x1FFF});
}

TEST(ReplayMaster, EndsAfterTheLastRow) {
  ReplayMaster master(twoRows(), Rig{}, kOnce);
  EXPECT_NEAR(at(*master.read(20 * kMillisecond, {}), Dof::HeadX), 0.2, 1e-12);
  EXPECT_FALSE(master.read(20 * kMillisecond + 1, {}));
}

TEST(ReplayMaster, LoopsWithoutAJump) {
  ReplayMaster master(twoRows(), Rig{}, {.loop = true, .head_height = HeadHeight::Recorded});
  const std::int64_t cycle = 20 * kMillisecond + ReplayMaster::kLoopBlendNs;
  double before = 0.0;
  for (std::int64_t t = 20 * kMillisecond; t <= cycle; t += kMillisecond) {
    const double x = at(*master.read(t, {}), Dof::HeadX);
    if (t > 20 * kMillisecond) {
      ASSERT_LE(std::abs(x - before), 0.2 * 1.875e-3 + 1e-9) << t;
    }
    before = x;
  }
  EXPECT_NEAR(before, 0.0, 1e-12);
  EXPECT_NEAR(at(*master.read(cycle + 5 * kMillisecond, {}), Dof::HeadX), 0.05, 1e-12);
}

TEST(ReplayMaster, TheDevicesClockNeverGoesBack) {
  ReplayMaster master(twoRows(), Rig{});
  std::int64_t before = -1;
  for (std::int64_t t = 0; t < 4'000'000'000; t += 7 * kMillisecond) {
    const std::int64_t now = master.read(t, {})->device_time_us;
    ASSERT_GT(now, before);
    before = now;
  }
}

TEST(ReplayMaster, SeatsARecordingOfSomebodyWhoStands) {
  const Rig rig;
  ReplayMaster master(twoRows(), rig, {.loop = false});
  const Coord3 neutral = neutralHead(rig);
  const auto first = *master.read(0, {});
  EXPECT_NEAR(at(first, Dof::HeadX), neutral.x, 1e-12);
  EXPECT_NEAR(at(first, Dof::HeadY), neutral.y, 1e-12);
  EXPECT_NEAR(at(first, Dof::HeadZ), neutral.z, 1e-12);
  const auto last = *master.read(20 * kMillisecond, {});
  EXPECT_NEAR(at(last, Dof::HeadY) - at(first, Dof::HeadY), 0.1, 1e-12) << "the path keeps its shape";
}

TEST(ReplayMaster, OneRowIsAPosture) {
  Recording r = twoRows();
  r.rows.resize(1);
  ReplayMaster master(r, Rig{}, {.loop = true, .head_height = HeadHeight::Recorded});
  for (const std::int64_t t : {0L, 1L, 999'999'999L, 1'000'000'000L, 123'456'789'012L}) {
    EXPECT_NEAR(at(*master.read(t, {}), Dof::HeadY), 1.6, 1e-12);
  }
}

RC_GTEST_PROP(ReplayMaster, StaysBetweenItsRows, ()) {
  ReplayMaster master(twoRows(), Rig{}, {.loop = true, .head_height = HeadHeight::Recorded});
  const auto t = *rc::gen::inRange<std::int64_t>(0, 100'000'000'000);
  const auto reading = *master.read(t, {});
  RC_ASSERT(at(reading, Dof::HeadX) >= -1e-12 && at(reading, Dof::HeadX) <= 0.2 + 1e-12);
  RC_ASSERT(at(reading, Dof::HeadYaw) >= -1e-9 && at(reading, Dof::HeadYaw) <= 0.6 + 1e-9);
  RC_ASSERT(at(reading, Dof::ElbowFlexion) >= -1e-12 && at(reading, Dof::ElbowFlexion) <= 2.0 + 1e-12);
}

/// Every recording, as the server plays it: all values pass the gate, and at a row's time the row comes out.
TEST(ReplayMaster, RecordingsOfPeoplePassTheGate) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(COHERENCY_MOTION_DATA)) GTEST_SKIP() << "no recordings at " COHERENCY_MOTION_DATA;
  const Rig rig;
  for (const auto& entry : fs::directory_iterator(COHERENCY_MOTION_DATA)) {
    const std::string path = entry.path().string();
    if (entry.path().extension() != ".csv" || path.find("_headhand") != std::string::npos) continue;
    const Recording recording = readRecording(path);
    for (const HeadHeight height : {HeadHeight::Seated, HeadHeight::Recorded}) {
      ReplayMaster master(recording, rig, {.loop = false, .head_height = height});
      SampleGate gate(neutralPosture(rig));
      MotionSample sample;
      for (const RecordedRow& row : recording.rows) sample = gate.admit(*master.read(row.time_ns, {}), 1, 0);
      for (std::size_t i = 0; i < kDofCount; ++i)
        EXPECT_EQ(gate.refused()[i], 0u) << path << dofTable()[i].name;
      if (height == HeadHeight::Recorded) {
        EXPECT_NEAR(sample.si(Dof::HeadY), recording.rows.back().head.y, 1e-6);
      }
      const YawPitchRoll attitude{sample.si(Dof::HeadYaw), sample.si(Dof::HeadPitch),
                                  sample.si(Dof::HeadRoll)};
      EXPECT_LT(largestDifference(rotation(attitude), rotation(recording.rows.back().attitude)), 1e-8)
          << path;
    }
  }
}

}  // namespace
}  // namespace coherency
