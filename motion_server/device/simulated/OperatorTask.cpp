#include "motion_server/device/simulated/OperatorTask.h"

#include <array>
#include <cstdio>

#include "common/world/Scene.h"
#include "motion_server/device/simulated/Seating.h"

namespace coherency {

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
  return task;
}

std::vector<std::string> outOfReach(const Scene& scene, const WorldState& start) {
  std::vector<std::string> sentences;
  if (start.movables.empty()) return sentences;
  const OperatorTask task = operatorTask(scene);
  const ReachPlanner planner(scene.world().model().master.rig);
  const Seating seating(planner, task.grasp_point);
  std::vector<Coord3> blocks;
  for (const Movable& m : start.movables) blocks.push_back(transform(m).origin());
  for (const Mode mode : {Mode::Operator, Mode::Robot}) {
    if (!scene.world().has(mode)) continue;
    const bool robot = mode == Mode::Robot;
    const double scale = robot ? task.robot_scale : 1.0;
    const BasePose base = seating.place(robot ? task.robot_workplace : task.workplace, blocks, scale);
    if (seating.canBuild(blocks, base, scale)) continue;
    std::array<char, 32> size{};
    if (robot) std::snprintf(size.data(), size.size(), " (scale %g)", scale);
    sentences.push_back(std::string(robot ? "the robot" : "the operator") + size.data() +
                        " cannot reach the blocks from its workplace");
  }
  return sentences;
}

}  // namespace coherency
