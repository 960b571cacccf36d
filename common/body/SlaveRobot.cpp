#include "common/body/SlaveRobot.h"

#include "common/body/robot/RobotArm.h"
#include "common/body/robot/RobotHead.h"
#include "common/body/robot/RobotTrunk.h"

namespace coherency {

struct SlaveRobot::Shapes {
  explicit Shapes(const Rig& rig) : trunk(rig), head(rig), arm(rig) {}

  RobotTrunk trunk;
  RobotHead head;
  RobotArm arm;
};

SlaveRobot::SlaveRobot(const Rig& robot_rig)
    : PosedBody("slave robot", robot_rig), shapes_(std::make_unique<Shapes>(robot_rig)) {
  addMember(&shapes_->trunk);
  addMember(&shapes_->head);
  addMember(&shapes_->arm);
  setSample(neutralSample(robot_rig));
}

SlaveRobot::~SlaveRobot() = default;

void SlaveRobot::setSample(const MotionSample& sample) {
  takeUp(sample);
  shapes_->trunk.setPosture(posture());
  shapes_->head.setPosture(posture());
  shapes_->arm.setPosture(posture(), sample.si(Dof::Grip));
}

}  // namespace coherency
