// What does not say that it moves never does, whatever goes on in a scene: it can be compiled (paper, section
// III.C.1).

#include <cmath>
#include <deque>
#include <set>

#include <gtest/gtest.h>

#include "common/scene/Light.h"
#include "tests/scene/WatchSupport.h"
#include "tests/scenes/Support.h"
#include "tests/world/Support.h"

namespace coherency {
namespace {

using namespace scenes;

constexpr std::int64_t kStep = 10'000'000;  // ns
constexpr int kSteps = 600;

/// Whether it is part of something with the attribute Moving, or has it.
bool moves(const VRObject& object) {
  for (const VRObject* above = &object; above != nullptr; above = above->parent())
    if (above->attribute<Moving>() != nullptr) return true;
  return false;
}

/// All DOFs swing, each at a rate of its own; the hand stays closed.
MotionSample swinging(const Rig& rig, double t) {
  MotionSample sample = neutralSample(rig);
  sample.valid = kAllDofs;
  for (std::size_t i = 0; i < kDofCount; ++i) {
    const DofInfo& dof = dofTable()[i];
    const double swing = std::sin(t * (1.0 + 0.1 * static_cast<double>(i)));
    if (dof.kind == DofKind::Length)
      sample.units[i] += unitsFromSi(dof.kind, 0.1 * swing);
    else
      sample.units[i] = unitsFromSi(dof.kind, std::lerp(dof.min, dof.max, 0.5 + 0.35 * swing));
  }
  sample.units[index(Dof::Grip)] = unitsFromRatio(0.9);
  return sample;
}

/// One block in each hand there is, and the others let go in the air.
WorldState busyState(const Scene& scene, Mode mode) {
  WorldState state = scene.initialState();
  state.mode = mode;
  state.closed_hands = scene.robot() == nullptr ? 1 : 3;
  for (std::size_t i = 0; i < state.movables.size(); ++i) {
    Movable& block = state.movables[i];
    if (i > 1 || (i == 1 && scene.robot() == nullptr)) {
      block = worlds::letGo(worlds::place(block) + Coord3(0.0, 0.3, 0.0));
      continue;
    }
    block = worlds::letGo({0.09, -0.06, 0.0});
    block.holder = i == 0 ? Holder::OperatorHand : Holder::RobotHand;
  }
  return state;
}

/// Lets six seconds pass in which there is all that a scene can do.
void liveThrough(Scene& scene, Mode mode) {
  WorldState state = busyState(scene, mode);
  ASSERT_TRUE(scene.fits(state));
  for (int i = 0; i < kSteps; ++i) {
    const double t = 1e-9 * static_cast<double>(kStep * i);
    const MotionSample sample = swinging(Rig{}, t);
    scene.world().step(state, sample, kStep);
    for (std::int32_t& door : state.doors)
      door = static_cast<std::int32_t>(kDoorOpen * (0.5 - 0.5 * std::cos(t)));
    scene.apply(state, sample);
  }
}

/// What of the scene has to have moved for the test to be worth anything.
std::set<const VRObject*> movers(const Scene& scene) {
  std::set<const VRObject*> all;
  forEachObject(scene, {}, [&](const VRObject& object, const TransformMatrix&) {
    if (object.attribute<Moving>() != nullptr) all.insert(&object);
  });
  if (scene.description().driving) return all;
  all.erase(&scene.human());
  all.erase(scene.robot());
  return all;
}

TEST(Scenes, MoveNothingThatDoesNotSayItMovesAndChangeNoShape) {
  for (const std::string& name : kShipped) {
    Scene scene(described(name), Rig{});
    std::deque<Recorder> still, moving;
    forEachObject(scene, {}, [&](const VRObject& object, const TransformMatrix&) {
      (moves(object) ? moving : still).emplace_back(object);
    });
    EXPECT_FALSE(still.empty());
    EXPECT_FALSE(moving.empty());
    for (const Mode mode : {Mode::Operator, Mode::Robot})
      if (scene.world().has(mode)) liveThrough(scene, mode);
    for (Recorder& watch : still) EXPECT_TRUE(watch.heard().empty()) << watch.object()->path();
    std::set<const VRObject*> expected = movers(scene);
    for (Recorder& watch : moving) {
      for (const ObjectChange change : watch.heard()) {
        ASSERT_EQ(change, ObjectChange::Moved) << watch.object()->path();
        expected.erase(watch.object());
      }
    }
    for (const VRObject* object : expected) ADD_FAILURE() << object->path() << " could have moved";
  }
}

}  // namespace
}  // namespace coherency
