// The paper's numbers of polygons (section IV.B), and that none of them is there for the number alone.

#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include "common/body/SlaveRobot.h"
#include "common/body/VirtualHuman.h"
#include "common/body/master/MasterSystem.h"
#include "tests/human/Support.h"

namespace coherency::human {
namespace {

class PolygonsOf : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Rigs, PolygonsOf, testing::Values("default", "small", "large"));

TEST_P(PolygonsOf, TheMasterSystemAre336) {
  const VirtualHuman human(rigOf(GetParam()));
  EXPECT_EQ(human.master()->polygonCount(), 336U);
}

TEST_P(PolygonsOf, TheSlaveRobotAre834) {
  EXPECT_EQ(SlaveRobot(robotRig(rigOf(GetParam()))).polygonCount(), 834U);
}

TEST_P(PolygonsOf, TheHumanAreModerate) {
  const VirtualHuman human(rigOf(GetParam()));
  EXPECT_LE(human.polygonCount() - human.master()->polygonCount(), 9000U);
}

/// Where an eye at `eye` sees `point`: no other polygon that faces the eye lies between them.
bool seen(const Coord3& point, const Coord3& eye, const std::vector<Face>& faces, const Face& self) {
  const Coord3 ray = eye - point;
  for (const Face& face : faces) {
    if (&face == &self) continue;
    const double leaving = dot(face.normal, ray);
    if (leaving <= 0.0) continue;  // the eye is behind it, and it is not drawn
    const double at = dot(face.normal, face.corners[0] - point) / leaving;
    if (at <= 0.0 || at >= 1.0) continue;
    const Coord3 hit = point + ray * at;
    bool within = true;
    for (std::size_t i = 0; within && i < face.corners.size(); ++i) {
      const Coord3& here = face.corners[i];
      const Coord3& next = face.corners[(i + 1) % face.corners.size()];
      within = dot(cross(next - here, hit - here), face.normal) >= 0.0;
    }
    if (within) return false;
  }
  return true;
}

/// Whether somebody within arm's reach who keeps above the floor sees any of it.
bool seenFromSomewhere(const Face& face, const std::vector<Face>& faces) {
  constexpr int kDirections = 160;
  constexpr double kGolden = std::numbers::pi * (3.0 - 2.23606797749979);
  Coord3 middle;
  for (const Coord3& c : face.corners) middle += c / static_cast<double>(face.corners.size());
  std::vector<Coord3> points{middle};
  for (std::size_t i = 0; i < face.corners.size(); ++i)
    for (const double outward : {0.5, 0.8, 0.96}) {
      const Coord3& corner = face.corners[i];
      points.push_back(middle + (corner - middle) * outward);
      points.push_back(middle +
                       ((corner + face.corners[(i + 1) % face.corners.size()]) / 2.0 - middle) * outward);
    }
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1.0 - 2.0 * (i + 0.5) / kDirections;
    const double r = std::sqrt(1.0 - z * z);
    const Coord3 direction{r * std::cos(kGolden * i), z, r * std::sin(kGolden * i)};
    if (dot(direction, face.normal) < 0.05) continue;
    for (const Coord3& point : points) {
      const Coord3 eye = point + direction * 0.6;
      if (eye.y > 0.01 && seen(point + face.normal * 1e-6, eye, faces, face)) return true;
    }
  }
  return false;
}

/// Names of objects with polygons that nobody sees in any of the postures, and how many.
std::string unseen(const VRObject& root, const std::function<void(unsigned)>& pose) {
  std::map<const VRObject*, std::size_t> hidden;
  std::vector<bool> found;
  for (unsigned posture = 0; posture < 4; ++posture) {
    pose(posture);
    const std::vector<Face> faces = facesOf(root);
    found.resize(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) found[i] = found[i] || seenFromSomewhere(faces[i], faces);
  }
  const std::vector<Face> faces = facesOf(root);
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (!found[i]) ++hidden[faces[i].object];
  std::ostringstream text;
  for (const auto& [object, count] : hidden) text << object->path() << ": " << count << '\n';
  return text.str();
}

/// The neutral posture, and others that move everything.
MotionSample postureNumber(const Rig& rig, unsigned number) {
  return number == 0 ? sampleOf(rig, neutralPosture(rig)) : randomSample(rig, number);
}

TEST_P(PolygonsOf, TheMasterSystemAreAllSeenFromSomewhere) {
  const Rig rig = rigOf(GetParam());
  VirtualHuman human(rig);
  EXPECT_EQ(unseen(*human.master(), [&](unsigned i) { human.setSample(postureNumber(rig, i)); }), "");
}

TEST_P(PolygonsOf, TheSlaveRobotAreAllSeenFromSomewhere) {
  const Rig rig = robotRig(rigOf(GetParam()));
  SlaveRobot robot(rig);
  EXPECT_EQ(unseen(robot, [&](unsigned i) { robot.setSample(postureNumber(rig, i)); }), "");
}

}  // namespace
}  // namespace coherency::human
