#include "motion_server/device/simulated/OperatorTask.h"

#include <array>
#include <cstdio>

#include "common/world/Places.h"
#include "common/world/Scene.h"
#include "motion_server/device/simulated/Seating.h"
#include "motion_server/device/simulated/Workplan.h"

namespace coherency {

std::vector<Coord3> blocksNear(const WorldState& state, const BasePose& workplace) {
  constexpr double kNear = 1.5;  // m
  std::vector<Coord3> blocks;
  for (const Movable& m : state.movables) {
    const Coord3 at = transform(m).origin();
    if (m.holder == Holder::Nobody && at.y > kLowestWork && norm(at - transform(workplace).origin()) < kNear)
      blocks.push_back(at);
  }
  return blocks;
}

OperatorTask operatorTask(const Scene& scene) {
  OperatorTask task;
  const World& world = scene.world();
  for (const MovableModel& m : world.model().movables) task.edges.push_back(m.edge);
  task.targets = scene.targets();
  task.workplace = scene.workplace(Mode::Operator);
  if (scene.robot() != nullptr) task.robot_workplace = scene.workplace(Mode::Robot);
  const Rig& rig = world.model().master.rig;
  task.robot_scale = rig.robot_scale;
  task.grasp_point = world.hand(Holder::OperatorHand).graspPoint() - Coord3{rig.hand, 0.0, 0.0};
  task.clear = [&world](const BasePose& base, Mode mode) {
    const WorldModel& model = world.model();
    return standsFree(base, mode == Mode::Robot ? *model.robot : model.master, model);
  };
  return task;
}

std::vector<std::string> outOfReach(const Scene& scene, const WorldState& start) {
  std::vector<std::string> sentences;
  constexpr std::size_t kTower = 3;
  const OperatorTask task = operatorTask(scene);
  const ReachPlanner planner(scene.world().model().master.rig);
  const Seating seating(planner, task.grasp_point);
  for (const Mode mode : {Mode::Operator, Mode::Robot}) {
    if (!scene.world().has(mode)) continue;
    const bool robot = mode == Mode::Robot;
    const double scale = robot ? task.robot_scale : 1.0;
    const BasePose& workplace = robot ? task.robot_workplace : task.workplace;
    const std::vector<Coord3> blocks = blocksNear(start, workplace);
    if (blocks.size() < kTower) continue;  // nothing to build with, and nothing is promised
    const auto clear = [&](const BasePose& base) { return task.clear(base, mode); };
    const BasePose base = seating.place(workplace, blocks, scale, clear);
    if (seating.canBuild(blocks, base, scale)) continue;
    std::array<char, 32> size{};
    if (robot) std::snprintf(size.data(), size.size(), " (scale %g)", scale);
    sentences.push_back(std::string(robot ? "the robot" : "the operator") + size.data() +
                        " cannot reach the blocks from its workplace");
  }
  return sentences;
}

}  // namespace coherency
