#pragma once

#include "common/body/ArmKinematics.h"
#include "common/body/Rig.h"
#include "common/motion/MotionSample.h"

namespace coherency {

/// Where the virtual human's parts are, in the body frame; a function of rig and sample alone, nothing
/// accumulated.
struct Posture {
  TransformMatrix t_body_head;      ///< origin: head centre
  TransformMatrix t_body_thorax;    ///< origin: neck base; y from the hips to the neck base, no twist
  TransformMatrix t_body_shoulder;  ///< right shoulder joint, thorax axes
  ArmPose right_arm;                ///< relative to t_body_shoulder
  Coord3 hip;                       ///< middle between the hip joints
  double trunk_stretch = 1.0;       ///< hips to neck base as measured, over the rig's trunk_length
};

Posture posture(const Rig& rig, const ArmKinematics& arm, const MotionSample& sample);

/// T_head_eye: `side` is -1 for the left, +1 for the right, 0 for between the eyes.
TransformMatrix headToEye(const Rig& rig, int side);

/// Frame at `from` whose x axis points to `to` and whose z axis is as near to `z_hint` as that allows. Where
/// the two points are one, the axes are those of the hint. Precondition: z_hint is not zero.
TransformMatrix frameAlong(const Coord3& from, const Coord3& to, const Coord3& z_hint);

/// Middle joint of a limb of two segments (lengths `first`, `second`, both > 0) from `root` to `tip`, bent
/// towards the direction `pole` (not a point; its part along the limb does not matter). Where the tip is out
/// of reach the limb is straight, where it is too near the limb is folded, and `tip_reached` is as near as it
/// gets.
struct TwoBoneLimb {
  Coord3 joint;
  Coord3 tip_reached;
};
TwoBoneLimb twoBoneLimb(const Coord3& root, const Coord3& tip, double first, double second,
                        const Coord3& pole);

}  // namespace coherency
