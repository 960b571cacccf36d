#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/math/FixedPoint.h"
#include "common/motion/Dof.h"
#include "tests/math/Random.h"

namespace coherency {
namespace {

TEST(DofTable, NamesAreDistinctAndFound) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const DofInfo& dof = info(dofAt(i));
    EXPECT_TRUE(names.insert(dof.name).second) << dof.name;
    EXPECT_EQ(dofByName(dof.name), dofAt(i));
    EXPECT_FALSE(dof.meaning.empty());
  }
  EXPECT_EQ(dofByName("head_w"), std::nullopt);
  EXPECT_EQ(dofByName(""), std::nullopt);
}

TEST(DofTable, IsInWireOrder) {
  EXPECT_EQ(info(Dof::HeadX).name, "head_x");
  EXPECT_EQ(info(Dof::HeadYaw).name, "head_yaw");
  EXPECT_EQ(info(Dof::ShoulderFlexion).name, "shoulder_flexion");
  EXPECT_EQ(info(Dof::WristDeviation).name, "wrist_deviation");
  EXPECT_EQ(info(Dof::Grip).name, "grip");
  EXPECT_EQ(info(Dof::StickTwist).name, "stick_twist");
  EXPECT_EQ(index(Dof::PedalRight), kDofCount - 1);
}

TEST(DofTable, RangesHoldNeutralAndFitTheirIntegers) {
  for (const DofInfo& dof : dofTable()) {
    EXPECT_LE(dof.min, 0.0) << dof.name;
    EXPECT_GE(dof.max, 0.0) << dof.name;
    for (const double edge : {dof.min, dof.max}) {
      const double back = siFromUnits(dof.kind, unitsFromSi(dof.kind, edge));
      const double error = dof.kind == DofKind::Angle ? std::remainder(back - edge, kTurn) : back - edge;
      EXPECT_LE(std::abs(error), resolution(dof.kind)) << dof.name << " at " << edge;
    }
  }
}

RC_GTEST_PROP(DofUnits, ComeBackToHalfAUnit, ()) {
  const DofInfo& dof = dofTable()[*rc::gen::inRange<std::size_t>(0, kDofCount)];
  const double si = random::real(dof.min, dof.max);
  double error = siFromUnits(dof.kind, unitsFromSi(dof.kind, si)) - si;
  if (dof.kind == DofKind::Angle) error = std::remainder(error, kTurn);
  RC_ASSERT(std::abs(error) <= 0.5 * resolution(dof.kind) * (1.0 + 1e-6));
}

TEST(DofUnits, AnglesWrapAtPi) {
  constexpr double kPi = std::numbers::pi;
  EXPECT_EQ(unitsFromSi(DofKind::Angle, kPi), unitsFromSi(DofKind::Angle, -kPi));
  EXPECT_NEAR(siFromUnits(DofKind::Angle, unitsFromSi(DofKind::Angle, kPi)), -kPi, 1e-9);
}

TEST(DofUnits, KindsHaveUnits) {
  EXPECT_EQ(unitName(DofKind::Length), "m");
  EXPECT_EQ(unitName(DofKind::Angle), "rad");
  EXPECT_EQ(unitName(DofKind::Ratio), "");
  EXPECT_DOUBLE_EQ(resolution(DofKind::Length), 1e-6);
}

}  // namespace
}  // namespace coherency
