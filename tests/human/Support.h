#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/body/Footprint.h"
#include "common/body/Rig.h"
#include "common/motion/MotionSample.h"
#include "common/scene/VRObject.h"

// What the tests of bodies share: rigs, samples, and everything an object draws.

namespace coherency::human {

/// "default", "small" (0.85) or "large" (1.12): every length but the neck's offset.
Rig rigOf(const std::string& name);

/// All DOFs valid; as a master would report these values.
MotionSample sampleOf(const Rig& rig, const std::array<double, kDofCount>& si);
/// A posture somebody may have: arm and attitude within three quarters of their limits, the head within 0.2 m
/// of its place; the same for the same seed.
MotionSample randomSample(const Rig& rig, unsigned seed);

/// The neutral posture with one DOF a tenth of a metre or radian, or half of its range, elsewhere.
std::array<double, kDofCount> neutralBut(const Rig& rig, Dof dof);

/// Vertices of all that is drawn, by object, in the root's frame.
using Drawn = std::map<const VRObject*, std::vector<Coord3>>;
Drawn drawn(const VRObject& root);
/// How far any vertex has moved of the objects whose path contains `words`.
double farthestMove(const VRObject& root, const Drawn& before, const std::string& words = {});
/// Whether each DOF from `first` to `last` moves one of those by a millimetre or more, when it alone leaves
/// the neutral posture; `body` is a VirtualHuman or a SlaveRobot.
template <class Body>
void expectShown(Body& body, Dof first, Dof last, const std::string& words) {
  for (std::size_t i = index(first); i <= index(last); ++i) {
    body.setSample(sampleOf(body.rig(), neutralPosture(body.rig())));
    const Drawn before = drawn(body);
    body.setSample(sampleOf(body.rig(), neutralBut(body.rig(), dofAt(i))));
    EXPECT_GT(farthestMove(body, before, words), 0.001) << info(dofAt(i)).name << " on " << words;
  }
}
/// Takes up fifty postures and expects to be, back in the neutral one, exactly where it was.
template <class Body>
void expectToForget(Body& body) {
  const MotionSample neutral = sampleOf(body.rig(), neutralPosture(body.rig()));
  body.setSample(neutral);
  const Drawn before = drawn(body);
  for (unsigned i = 1; i <= 50; ++i) body.setSample(randomSample(body.rig(), i));
  EXPECT_GT(farthestMove(body, before), 0.0);
  body.setSample(neutral);
  EXPECT_EQ(farthestMove(body, before), 0.0);
}

/// A polygon in the root's frame; its normal leaves the side it is seen from.
struct Face {
  const VRObject* object;
  std::vector<Coord3> corners;
  Coord3 normal;
};
/// In the order of the tree.
std::vector<Face> facesOf(const VRObject& root);

/// Expects all that is drawn below the tallest disc, but for objects whose path contains one of `without`,
/// within the discs to 5 cm.
void expectWithin(const std::vector<FootprintDisc>& discs, const VRObject& root,
                  const std::vector<std::string>& without);

}  // namespace coherency::human
