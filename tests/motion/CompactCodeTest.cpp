#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/FixedPoint.h"
#include "common/motion/CompactCode.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

constexpr std::uint16_t kLastCode = 65534;

bool isWholeTurn(Dof dof) {
  return info(dof).kind == DofKind::Angle && info(dof).max - info(dof).min > kTurn - 1e-9;
}
/// SI; an angle's, the shorter way around.
double error(Dof dof, std::int32_t units, double si) {
  const double off = siFromUnits(info(dof).kind, units) - si;
  return std::abs(info(dof).kind == DofKind::Angle ? std::remainder(off, kTurn) : off);
}
std::int32_t throughCode(Dof dof, std::int32_t units) {
  return unitsFromCode(dof, compactCode(dof, units));
}

TEST(CompactCode, EveryCodeComesBackAsItself) {
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const Dof dof = dofAt(i);
    const int last = isWholeTurn(dof) ? kLastCode - 1 : kLastCode;
    int wrong = 0;
    for (int code = 0; code <= last; ++code) {
      const auto c = static_cast<std::uint16_t>(code);
      if (compactCode(dof, unitsFromCode(dof, c)) != c) ++wrong;
    }
    EXPECT_EQ(wrong, 0) << info(dof).name;
    EXPECT_EQ(unitsFromCode(dof, 65535), unitsFromCode(dof, kLastCode)) << info(dof).name;
  }
}

TEST(CompactCode, CodesRiseOverTheRangeFromEndToEnd) {
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const Dof dof = dofAt(i);
    const DofInfo& d = info(dof);
    EXPECT_LE(error(dof, unitsFromCode(dof, 0), d.min), resolution(d.kind)) << d.name;
    EXPECT_LE(error(dof, unitsFromCode(dof, kLastCode), d.max), resolution(d.kind)) << d.name;
    int wrong = 0;
    for (int code = 0; code < kLastCode; ++code) {
      const auto c = static_cast<std::uint16_t>(code);
      const double step = (d.max - d.min) / kLastCode;
      if (error(dof, unitsFromCode(dof, c), d.min + step * code) > resolution(d.kind)) ++wrong;
    }
    EXPECT_EQ(wrong, 0) << d.name;
  }
}

TEST(CompactCode, BothEndsOfAWholeTurnAreOneAngle) {
  for (const Dof dof : {Dof::HeadYaw, Dof::HeadRoll}) {
    ASSERT_TRUE(isWholeTurn(dof));
    EXPECT_EQ(unitsFromCode(dof, kLastCode), unitsFromCode(dof, 0));
    EXPECT_EQ(compactCode(dof, INT32_MIN), 0);
    EXPECT_EQ(throughCode(dof, INT32_MAX), INT32_MIN)
        << "half a turn to the left is half a turn to the right";
  }
}

RC_GTEST_PROP(CompactCode, NothingInRangeIsOffByMoreThanTheErrorItSays, ()) {
  const Dof dof = dofAt(*rc::gen::inRange<std::size_t>(0, kDofCount));
  const DofInfo& d = info(dof);
  const std::int32_t units = unitsFromSi(d.kind, random::real(d.min, d.max));
  RC_ASSERT(error(dof, throughCode(dof, units), siFromUnits(d.kind, units)) <= compactError(dof));
}

TEST(CompactCode, ErrorsAreThoseTheHeaderNames) {
  EXPECT_NEAR(compactError(Dof::HeadX), 0.31e-3 / 2, 0.005e-3);
  EXPECT_NEAR(compactError(Dof::HeadYaw), kTurn * 0.0055 / 360 / 2, 1e-6);
  EXPECT_NEAR(compactError(Dof::StickX), 0.00003 / 2, 1e-6);
}

TEST(CompactCode, ZeroOfARangeAboutZeroIsExact) {
  int about_zero = 0;
  for (std::size_t i = 0; i < kDofCount; ++i) {
    if (dofTable()[i].min != -dofTable()[i].max) continue;
    ++about_zero;
    EXPECT_EQ(throughCode(dofAt(i), 0), 0) << dofTable()[i].name;
  }
  EXPECT_GE(about_zero, 9);
  for (const Dof dof : {Dof::Grip, Dof::PedalLeft, Dof::PedalRight}) EXPECT_EQ(throughCode(dof, 0), 0);
}

RC_GTEST_PROP(CompactCode, WhatIsOutOfRangeLandsOnTheNearestEnd, ()) {
  const Dof dof = dofAt(*rc::gen::inRange<std::size_t>(0, kDofCount));
  const DofInfo& d = info(dof);
  if (isWholeTurn(dof)) return;
  const auto units = *rc::gen::arbitrary<std::int32_t>();
  const double si = siFromUnits(d.kind, units);
  const bool angle = d.kind == DofKind::Angle;
  const double above = angle ? std::remainder(si - d.max, kTurn) : si - d.max;
  const double below = angle ? std::remainder(d.min - si, kTurn) : d.min - si;
  const double beyond_max = above < 0 && angle ? above + kTurn : above;  // the way up, from the upper end
  const double beyond_min = below < 0 && angle ? below + kTurn : below;  // the way down, from the lower one
  const bool inside = angle ? beyond_max + beyond_min > kTurn : beyond_max <= 0 && beyond_min <= 0;
  if (inside || std::abs(beyond_max - beyond_min) < 1e-6) return;
  const bool upper = angle ? beyond_max < beyond_min : beyond_max > 0;
  RC_ASSERT(compactCode(dof, units) == (upper ? kLastCode : 0));
}

RC_GTEST_PROP(CompactCode, ACompactedSampleStaysAsItIs, ()) {
  MotionSample sample;
  sample.sequence = 7;
  sample.server_time_ns = 8;
  sample.device_time_us = 9;
  sample.valid = *rc::gen::inRange<DofMask>(0, kAllDofs + 1);
  for (std::int32_t& units : sample.units) units = *rc::gen::arbitrary<std::int32_t>();
  const MotionSample once = compacted(sample);
  RC_ASSERT(compacted(once) == once);
  MotionSample rest = once;
  rest.units = sample.units;
  RC_ASSERT(rest == sample);
}

}  // namespace
}  // namespace coherency
