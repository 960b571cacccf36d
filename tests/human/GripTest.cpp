// Fingers that lie on what they hold, the robot's as the human's (common/body/Grip.h).

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "common/body/Grip.h"
#include "common/body/SlaveRobot.h"
#include "common/body/VirtualHuman.h"
#include "common/world/Hands.h"
#include "tests/human/Support.h"

namespace coherency::human {
namespace {

constexpr double kInto = 0.002;  // m that fingers may give way
constexpr double kOff = 0.004;   // m that corners of a round finger may keep off

/// How deep a point is inside the cube at the grasp point; negative outside.
double inside(const Coord3& in_hand) {
  const Coord3 from = in_hand - Coord3{kUnitHand, -kHeldBelow, 0.0};
  return kHeldEdge / 2 - std::max({std::abs(from.x), std::abs(from.y), std::abs(from.z)});
}

struct Contact {
  double deepest = -1.0;
  double below_top = 0.0;  ///< how far down along the cube's sides the finger reaches
};

/// Of the right hand's objects whose path contains `words`.
template <class Body>
Contact contact(Body& body, double grip, const std::string& hand, const std::string& words) {
  auto si = neutralPosture(body.rig());
  si[index(Dof::Grip)] = grip;
  body.setSample(sampleOf(body.rig(), si));
  const TransformMatrix t_hand_body = body.rightHand().globalTransform().rigidInverse();
  Contact c;
  for (const Face& face : facesOf(body)) {
    const std::string path = face.object->path();
    if (path.find(hand) == std::string::npos || path.find(words) == std::string::npos) continue;
    for (const Coord3& corner : face.corners) {
      const Coord3 p = t_hand_body.point(corner);
      c.deepest = std::max(c.deepest, inside(p));
      c.below_top = std::max(c.below_top, -kHeldBelow + kHeldEdge / 2 - p.y);
    }
  }
  return c;
}

template <class Body>
void expectToHold(Body& body, const std::string& hand) {
  for (const char* finger : {"index finger", "middle finger", "ring finger", "thumb"}) {
    const Contact held = contact(body, kHoldingGrip, hand, finger);
    EXPECT_LE(held.deepest, kInto) << finger << " goes through the cube";
    EXPECT_GE(held.deepest, -kOff) << finger << " does not touch the cube";
    EXPECT_GE(held.below_top, 0.015) << finger << " reaches down its side";
  }
  EXPECT_LE(contact(body, kHoldingGrip, hand, "palm").deepest, 0.0);
  EXPECT_LE(contact(body, 0.0, hand, "").deepest, 0.0) << "an open hand goes around it";
}

TEST(Grip, HumanFingersLieOnACube) {
  VirtualHuman human{Rig{}};
  expectToHold(human, "right arm hand");
}

TEST(Grip, RobotFingersLieOnACube) {
  SlaveRobot robot{robotRig(Rig{})};
  expectToHold(robot, "robot hand");
}

TEST(Grip, IsBestWhereTheWorldLooksForWhatIsGrasped) {
  VehicleModel model;
  const Coord3 point = GraspingHand(model, Holder::OperatorHand).graspPoint();
  EXPECT_LT(norm(point - Coord3{kUnitHand, -kHeldBelow, 0.0}), 1e-12);
  EXPECT_GT(kHoldingGrip, kClosesAt) << "a hand has closed by then";
}

TEST(Grip, ClosesWithoutAJump) {
  const FingerShape finger{"finger", {0.095, 0.0, 0.0}, 0.1, 1.0, {0.042, 0.026, 0.022}, 0.009};
  double before = fingerBend(finger, 0.0).curl[1];
  for (int i = 1; i <= 100; ++i) {
    const double now = fingerBend(finger, i / 100.0).curl[1];
    EXPECT_GE(now, before - 1e-12);
    EXPECT_LT(now - before, 0.05);
    before = now;
  }
}

}  // namespace
}  // namespace coherency::human
