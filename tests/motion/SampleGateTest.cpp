#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/motion/SampleGate.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::array<double, kDofCount> neutral() {
  std::array<double, kDofCount> si{};
  si[index(Dof::HeadY)] = 1.16;
  si[index(Dof::ElbowFlexion)] = 1.5;
  return si;
}

MasterReading randomReading() {
  MasterReading reading;
  for (std::size_t i = 0; i < kDofCount; ++i)
    reading.si[i] = random::real(dofTable()[i].min, dofTable()[i].max);
  return reading;
}

TEST(SampleGate, PassesWhatIsInRange) {
  SampleGate gate(neutral());
  MasterReading reading;
  reading.si[index(Dof::HeadX)] = -0.25;
  reading.device_time_us = 77;
  const MotionSample sample = gate.admit(reading, 5, 1234);
  EXPECT_EQ(sample.sequence, 5u);
  EXPECT_EQ(sample.server_time_ns, 1234);
  EXPECT_EQ(sample.device_time_us, 77);
  EXPECT_EQ(sample.valid, kAllDofs);
  EXPECT_EQ(sample.units[index(Dof::HeadX)], -250000);
}

TEST(SampleGate, HoldsNeutralBeforeADofWasEverValid) {
  SampleGate gate(neutral());
  MasterReading reading;
  reading.valid = 0;
  const MotionSample sample = gate.admit(reading, 1, 0);
  EXPECT_EQ(sample.valid, 0u);
  EXPECT_NEAR(sample.si(Dof::HeadY), 1.16, 1e-6);
  EXPECT_NEAR(sample.si(Dof::ElbowFlexion), 1.5, 1e-9);
}

TEST(SampleGate, UnknownValidityBitsAreDropped) {
  SampleGate gate(neutral());
  MasterReading reading;
  reading.valid = ~DofMask{0};
  EXPECT_EQ(gate.admit(reading, 1, 0).valid, kAllDofs);
}

RC_GTEST_PROP(SampleGate, RefusesBadValuesHoldsTheLastAndCounts, ()) {
  SampleGate gate(neutral());
  const MasterReading good = randomReading();
  const MotionSample before = gate.admit(good, 1, 0);
  MasterReading bad = randomReading();
  const auto broken = *rc::gen::inRange<std::size_t>(0, kDofCount);
  const DofInfo& dof = dofTable()[broken];
  bad.si[broken] = *rc::gen::element(kNan, kInfinity, -kInfinity, 1e300, dof.max + 1e-6, dof.min - 1e-6);
  const MotionSample after = gate.admit(bad, 2, 0);
  RC_ASSERT(after.valid == (kAllDofs & ~mask(dofAt(broken))));
  RC_ASSERT(after.units[broken] == before.units[broken]);
  for (std::size_t i = 0; i < kDofCount; ++i) {
    RC_ASSERT(gate.refused()[i] == (i == broken ? 1u : 0u));
    if (i != broken) RC_ASSERT(after.units[i] == unitsFromSi(dofTable()[i].kind, bad.si[i]));
  }
}

TEST(SampleGate, WhatIsNotMeasuredIsNotCountedAsRefused) {
  SampleGate gate(neutral());
  MasterReading reading;
  reading.si[index(Dof::Grip)] = kNan;
  reading.valid = kAllDofs & ~mask(Dof::Grip);
  gate.admit(reading, 1, 0);
  EXPECT_EQ(gate.refused()[index(Dof::Grip)], 0u);
}

}  // namespace
}  // namespace coherency
