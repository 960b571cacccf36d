// What is drawn of somebody's own head, and of what is mounted on it or about it, is for others to see.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/body/SlaveRobot.h"
#include "common/body/VirtualHuman.h"
#include "common/body/master/MasterSystem.h"
#include "tests/human/Support.h"

namespace coherency::human {
namespace {

constexpr double kFree = 50.0 * std::numbers::pi / 180.0;  // about straight ahead
constexpr int kSteps = 12;                                 // points along each side of a triangle

/// Least angle between the eye's -z and any point of a face.
double leastAngle(const TransformMatrix& t_eye_body, const Face& face) {
  double least = std::numbers::pi;
  for (std::size_t c = 2; c < face.corners.size(); ++c)
    for (int i = 0; i <= kSteps; ++i)
      for (int k = 0; k <= kSteps - i; ++k) {
        const Coord3 on_face = face.corners[0] +
                               (face.corners[c - 1] - face.corners[0]) * (static_cast<double>(i) / kSteps) +
                               (face.corners[c] - face.corners[0]) * (static_cast<double>(k) / kSteps);
        const Coord3 p = t_eye_body.point(on_face);
        least = std::min(least, std::atan2(std::hypot(p.x, p.y), -p.z));
      }
  return least;
}

/// Names of objects with a face that an eye sees (they are drawn from one side) and that reaches into the
/// cone ahead of it, but for those whose path has one of `without`.
template <class Body>
std::set<std::string> inTheWay(const Body& body, const std::vector<std::string>& without) {
  std::set<std::string> names;
  for (const Eye which : {Eye::Left, Eye::Right, Eye::Mono}) {
    const TransformMatrix t_body_eye = body.eye(which).globalTransform();
    for (const Face& face : facesOf(body)) {
      const std::string path = face.object->path();
      const bool excepted = std::any_of(without.begin(), without.end(), [&](const std::string& words) {
        return path.find(words) != std::string::npos;
      });
      if (excepted || dot(face.normal, t_body_eye.origin() - face.corners[0]) <= 0.0) continue;
      if (leastAngle(t_body_eye.rigidInverse(), face) < kFree) names.insert(path);
    }
  }
  return names;
}

class OwnViewOf : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Rigs, OwnViewOf, testing::Values("default", "small", "large"));

TEST_P(OwnViewOf, OfTheOperatorIsFree) {
  const Rig rig = rigOf(GetParam());
  VirtualHuman human(rig);
  human.setSample(sampleOf(rig, neutralPosture(rig)));
  EXPECT_EQ(inTheWay(human, {"right arm", "exoskeleton"}), std::set<std::string>{});
}

/// Where the head turns, the display and the head turn with it.
TEST_P(OwnViewOf, OfTheOperatorIsNeverHeldUpByHeadOrDisplay) {
  const Rig rig = rigOf(GetParam());
  VirtualHuman human(rig);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    human.setSample(randomSample(rig, seed));
    EXPECT_EQ(
        inTheWay(human, {"arm", "exoskeleton", "leg", "trunk", "master seat", "pedal", "joystick", "mast"}),
        std::set<std::string>{})
        << "posture " << seed;
  }
}

TEST_P(OwnViewOf, OfTheRobotIsFree) {
  const Rig rig = robotRig(rigOf(GetParam()));
  SlaveRobot robot(rig);
  robot.setSample(sampleOf(rig, neutralPosture(rig)));
  EXPECT_EQ(inTheWay(robot, {"robot arm"}), std::set<std::string>{});
}

TEST_P(OwnViewOf, OfTheRobotIsNeverHeldUpByItsHead) {
  const Rig rig = robotRig(rigOf(GetParam()));
  SlaveRobot robot(rig);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    robot.setSample(randomSample(rig, seed));
    EXPECT_EQ(inTheWay(robot, {"robot arm", "robot trunk"}), std::set<std::string>{}) << "posture " << seed;
  }
}

TEST_P(OwnViewOf, ShowsTheHandThatIsHeldOutAhead) {
  const Rig rig = robotRig(rigOf(GetParam()));
  SlaveRobot robot(rig);
  auto si = neutralPosture(rig);
  si[index(Dof::ShoulderFlexion)] = 1.3;
  si[index(Dof::ElbowFlexion)] = 0.3;
  robot.setSample(sampleOf(rig, si));
  const std::set<std::string> seen = inTheWay(robot, {"robot head", "robot trunk"});
  EXPECT_TRUE(std::any_of(seen.begin(), seen.end(), [](const std::string& path) {
    return path.find("robot hand/robot index finger") != std::string::npos;
  }));
}

}  // namespace
}  // namespace coherency::human
