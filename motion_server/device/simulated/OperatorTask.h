#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/world/WorldState.h"

namespace coherency {

class Scene;

/// What the simulated operator has to do; all in world coordinates.
struct OperatorTask {
  std::vector<double> edges;    ///< of the movables there are, m
  std::vector<Coord3> targets;  ///< where to put a hand when there is nothing to build with (Scene::targets)
  BasePose workplace;           ///< where the base should be to reach them
  BasePose robot_workplace;     ///< and the robot's
  double robot_scale = 1.0;
  /// Whether a base can stand there in that mode; empty: everywhere.
  std::function<bool(const BasePose&, Mode)> clear = {};
  Coord3 grasp_point;  ///< of what a hand grasps best, from the middle of the palm in the hand's axes, m
};

/// What there is to do in a scene, which outlives it.
OperatorTask operatorTask(const Scene& scene);

/// Of the movables nobody holds, those worth working with from a workplace: on a table, and not a walk away.
std::vector<Coord3> blocksNear(const WorldState& state, const BasePose& workplace);

/// One sentence for each body the operator can have that cannot do the task, as "the robot (scale 0.6) cannot
/// reach the blocks from its workplace"; none where all can.
std::vector<std::string> outOfReach(const Scene& scene, const WorldState& start);

}  // namespace coherency
