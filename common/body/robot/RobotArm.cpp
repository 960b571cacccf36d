#include "common/body/robot/RobotArm.h"

#include "common/body/ArmParts.h"
#include "common/body/Assemble.h"
#include "common/body/robot/RobotSize.h"
#include "common/math/FixedPoint.h"

namespace coherency {

namespace {

using enum Loft::Along;

std::vector<Turned::Ring> scaled(std::vector<Turned::Ring> rings, double along, double k) {
  for (auto& ring : rings) ring = {ring.at * along, ring.radius * k};
  return rings;
}

}  // namespace

RobotArm::RobotArm(const Rig& rig)
    : VRObject("robot arm"), base_(ArmKinematics(rig).base()), hand_(rig.hand) {
  for (VRObject* frame : {&base_frame_, &flexed_, &abducted_, &upper_, &bent_, &forearm_, &deviated_})
    addMember(frame);
  addMember(&hand_);
  const TransformMatrix hinge = ArmKinematics::hingeFrame();
  upper_.addMember(&upper_hinge_);
  upper_hinge_.setTransform(hinge);
  bent_.addMember(&bent_hinge_);
  bent_hinge_.setTransform(hinge);
  const RobotSize size(rig);
  buildShoulder(size.arm, size.wide);
  buildUpperArm(rig, size.arm);
  buildForearm(rig, size.arm);
  buildWrist(rig, size.arm);
}

/// The motor of j1 reaches out of the chest, its fork carries the block that j2 turns, and j3 turns below it.
void RobotArm::buildShoulder(double k, double wide) {
  j1_.setProfile(X, 12, {{-0.125 * wide, 0.050 * k}, {-0.052 * k, 0.050 * k}}, Ends::Last);
  assemble(base_frame_, j1_, "robot j1", robot_paint::joint());
  shoulder_fork_.setForm(Y, {0.050 * k, 0.062 * k, 0.028 * k, kTurn / 2, kTurn, 4}, Ends::Open);
  assemble(flexed_, shoulder_fork_, "robot shoulder fork", robot_paint::hull());
  j2_.setProfile(Z, 10, scaled({{-0.068, 0.030}, {0.068, 0.030}}, k, k), Ends::Both);
  assemble(abducted_, j2_, "robot j2", robot_paint::joint());
  j3_.setProfile(Y, 12, scaled({{-0.098, 0.045}, {-0.040, 0.047}, {0.034, 0.036}}, k, k), Ends::Both);
  assemble(abducted_, j3_, "robot j3", robot_paint::metal());
}

void RobotArm::buildUpperArm(const Rig& rig, double k) {
  const double l = rig.upper_arm / 0.29;
  upper_shell_.setProfile(X, 12, scaled({{0.098, 0.041}, {0.150, 0.042}, {0.228, 0.031}}, l, k), Ends::Last);
  assemble(upper_, upper_shell_, "robot upper arm shell", robot_paint::hull());
  upper_band_.setProfile(X, 12, scaled({{0.108, 0.0435}, {0.126, 0.0435}}, l, k), Ends::Open);
  assemble(upper_, upper_band_, "robot upper arm band", robot_paint::accent());
  for (std::size_t i = 0; i < 2; ++i) {
    const double aside = (i == 0 ? -0.034 : 0.034) * k;
    elbow_cheeks_[i].setSections(X, 0.0,
                                 {{0.190 * l, 0.018 * k, 0.007 * k, 0.0, 0.8 * aside},
                                  {rig.upper_arm - 0.006 * k, 0.026 * k, 0.007 * k, 0.0, aside},
                                  {rig.upper_arm + 0.024 * k, 0.014 * k, 0.007 * k, 0.0, aside}},
                                 Ends::Last);
    assemble(upper_hinge_, elbow_cheeks_[i], "robot elbow cheek", robot_paint::joint());
  }
}

void RobotArm::buildForearm(const Rig& rig, double k) {
  const double l = rig.forearm / 0.26;
  j4_.setProfile(Z, 10, scaled({{-0.048, 0.021}, {0.048, 0.021}}, k, k), Ends::Both);
  assemble(bent_hinge_, j4_, "robot j4", robot_paint::metal());
  j5_.setProfile(X, 12, scaled({{-0.022, 0.018}, {0.030, 0.026}, {0.062, 0.037}, {0.112, 0.038}}, l, k),
                 Ends::First);
  assemble(bent_, j5_, "robot j5", robot_paint::metal());
  forearm_shell_.setProfile(X, 12, scaled({{0.112, 0.0345}, {0.150, 0.035}, {0.222, 0.025}}, l, k),
                            Ends::Last);
  assemble(forearm_, forearm_shell_, "robot forearm shell", robot_paint::hull());
  forearm_band_.setProfile(X, 12, scaled({{0.120, 0.0365}, {0.136, 0.0365}}, l, k), Ends::Open);
  assemble(forearm_, forearm_band_, "robot forearm band", robot_paint::accent());
}

void RobotArm::buildWrist(const Rig& rig, double k) {
  const double l = rig.forearm / 0.26;
  for (std::size_t i = 0; i < 2; ++i) {
    const double aside = (i == 0 ? -0.024 : 0.024) * k;
    wrist_cheeks_[i].setSections(X, 0.0,
                                 {{0.200 * l, 0.005 * k, 0.012 * k, 0.8 * aside},
                                  {rig.forearm + 0.014 * k, 0.005 * k, 0.015 * k, aside}},
                                 Ends::Last);
    assemble(forearm_, wrist_cheeks_[i], "robot wrist cheek", robot_paint::joint());
  }
  j7_.setProfile(Y, 8, scaled({{-0.034, 0.014}, {0.034, 0.014}}, k, k), Ends::Both);
  assemble(deviated_, j7_, "robot j7", robot_paint::metal());
  j6_.setProfile(Z, 8, scaled({{-0.026, 0.016}, {0.026, 0.016}}, k, k), Ends::Both);
  assemble(deviated_, j6_, "robot j6", robot_paint::joint());
}

void RobotArm::setPosture(const Posture& posture, double grip) {
  base_frame_.setTransform(posture.t_body_shoulder * base_);
  setArm(posture, {&flexed_, &abducted_, &upper_, &bent_, &forearm_, &deviated_, &hand_});
  hand_.setGrip(grip);
}

}  // namespace coherency
