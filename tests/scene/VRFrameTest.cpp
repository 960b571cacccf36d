#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "common/scene/VRFrame.h"
#include "tests/math/Random.h"
#include "tests/scene/Support.h"

namespace coherency {
namespace {

TEST(VRFrame, StartsAtItsParent) {
  EXPECT_EQ(VRFrame().transform(), TransformMatrix());
}

RC_GTEST_PROP(VRFrame, PositionAndOrientationAreIndependent, ()) {
  const Coord3 position = random::vector(100.0);
  const TransformMatrix orientation = random::rotationMatrix();
  VRFrame frame;
  frame.setPosition(position);
  frame.setOrientation(orientation);
  RC_ASSERT(frame.position() == position);
  RC_ASSERT(frame.orientation() == orientation);
  frame.setPosition(2.0 * position);
  RC_ASSERT(frame.orientation() == orientation);
  RC_ASSERT(frame.position() == 2.0 * position);
}

TEST(VRFrame, OrientationIgnoresATranslationGivenWithIt) {
  VRFrame frame;
  frame.setPosition(1.0, 2.0, 3.0);
  frame.setOrientation(TransformMatrix::translation({9.0, 9.0, 9.0}) * TransformMatrix::rotationX(0.1));
  EXPECT_EQ(frame.position(), Coord3(1.0, 2.0, 3.0));
}

TEST(VRFrame, TranslatesInTheParentsAxesAndTurnsInItsOwn) {
  VRFrame frame;
  frame.setOrientation(YawPitchRoll{1.0, 0.0, 0.0});
  frame.translate({1.0, 0.0, 0.0});
  frame.translate({0.0, 2.0, 0.0});
  EXPECT_EQ(frame.position(), Coord3(1.0, 2.0, 0.0));
  frame.rotate(TransformMatrix::rotationX(0.5));
  frame.scale({1.0, 1.0, 3.0});
  const TransformMatrix expected = TransformMatrix::rotationY(1.0) * TransformMatrix::rotationX(0.5) *
                                   TransformMatrix::scaling({1.0, 1.0, 3.0});
  EXPECT_LT(largestDifference(frame.orientation(), expected), 1e-15);
  EXPECT_EQ(frame.position(), Coord3(1.0, 2.0, 0.0));
}

TEST(VRFrame, RefusesWhatIsNotFiniteAndStaysAsItWas) {
  VRFrame frame;
  frame.setPosition(1.0, 2.0, 3.0);
  const TransformMatrix before = frame.transform();
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    expectRefusal<std::domain_error>([&] { frame.setPosition(0.0, bad, 0.0); }, "position", "not finite");
    expectRefusal<std::domain_error>(
        [&] {
          frame.setTransform(TransformMatrix::scaling({1.0, bad, 1.0}));
        },
        "transform", "not finite");
    EXPECT_THROW(frame.setOrientation(YawPitchRoll{bad, 0.0, 0.0}), std::domain_error);
    EXPECT_THROW(frame.scale({bad, 1.0, 1.0}), std::domain_error);
    EXPECT_THROW(frame.translate({0.0, 0.0, bad}), std::domain_error);
    EXPECT_EQ(frame.transform(), before);
  }
}

}  // namespace
}  // namespace coherency
