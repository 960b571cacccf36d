#pragma once

#include "common/world/WorldState.h"

namespace coherency {

/// Whom the operator acts as: the virtual human or the slave robot, which may be of another size. Converts
/// between the world and the operator's own body, in the operator's own measures.
struct Embodied {
  /// `robot_scale`: the robot's size over the operator's.
  Embodied(const WorldState& world, double robot_scale)
      : base(world.driven().base),
        t_world_body(transform(base)),
        scale(world.mode == Mode::Robot ? robot_scale : 1.0),
        hand(world.mode == Mode::Robot ? Holder::RobotHand : Holder::OperatorHand) {}

  Coord3 toBody(const Coord3& world) const { return t_world_body.rigidInverse().point(world) / scale; }
  Coord3 toWorld(const Coord3& body) const { return t_world_body.point(body * scale); }

  BasePose base;
  TransformMatrix t_world_body;
  double scale;
  Holder hand;
};

}  // namespace coherency
