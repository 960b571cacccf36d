#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "common/body/Rig.h"

namespace coherency {
namespace {

TEST(Rig, DefaultIsValidAndItsNeutralPostureIsAdmissible) {
  const Rig rig;
  EXPECT_NO_THROW(validate(rig));
  const auto si = neutralPosture(rig);
  for (std::size_t i = 0; i < kDofCount; ++i) {
    EXPECT_GE(si[i], dofTable()[i].min) << dofTable()[i].name;
    EXPECT_LE(si[i], dofTable()[i].max) << dofTable()[i].name;
  }
}

TEST(Rig, ExtremeRigsStillHaveAnAdmissibleNeutralPosture) {
  for (const bool largest : {false, true}) {
    Rig rig;
    for (const RigField& field : rigFields()) rig.*field.value = largest ? field.max : field.min;
    EXPECT_NO_THROW(validate(rig));
    const auto si = neutralPosture(rig);
    for (std::size_t i = 0; i < kDofCount; ++i) {
      EXPECT_GE(si[i], dofTable()[i].min) << dofTable()[i].name;
      EXPECT_LE(si[i], dofTable()[i].max) << dofTable()[i].name;
    }
  }
}

TEST(Rig, EveryMeasureIsCheckedAndNamed) {
  for (const RigField& field : rigFields()) {
    for (const double bad : {field.min - 0.01, field.max + 0.01, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
      Rig rig;
      rig.*field.value = bad;
      try {
        validate(rig);
        ADD_FAILURE() << field.name << " = " << bad << " was accepted";
      } catch (const std::domain_error& error) {
        EXPECT_NE(std::string(error.what()).find(field.name), std::string::npos) << error.what();
      }
    }
  }
}

}  // namespace
}  // namespace coherency
